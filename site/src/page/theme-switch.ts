/**
 * The choice of colours in every page's header. May import `ui`.
 */
import { html, render } from "lit";
import { themeWords } from "../ui/strings.ts";
import { currentTheme, setTheme, THEMES } from "../ui/theme.ts";

export function showThemeSwitch(place: HTMLElement): void {
  const chosen = currentTheme();
  const onChange = (event: Event): void => {
    const { value } = event.target as HTMLSelectElement;
    const theme = THEMES.find((name) => name === value);
    if (theme) setTheme(theme);
  };
  render(
    html`<label for="theme">${themeWords.label}</label>
      <select id="theme" @change=${onChange}>
        ${THEMES.map(
          (theme) =>
            html`<option value=${theme} ?selected=${theme === chosen}>${themeWords[theme]}</option>`,
        )}
      </select>`,
    place,
  );
}
