/**
 * Finding things in a page as a person does, by role and label. The functions here run inside the
 * page: each must stand by itself.
 */

/**
 * Where something is: its role, its label (a part of the label if `loosely`), and the thing that it is in.
 * @typedef {{ role: string, name?: string, loosely?: boolean, within?: Where }} Where
 */

/**
 * The first element in sight that has the role and the label; null if there is none.
 *
 * Knows the roles that the stories name, not the whole of ARIA: the other browser tests look closely
 * at names and roles. Here it only matters that three engines are asked the same.
 * @param {Where} where
 * @returns {HTMLElement | null}
 */
export function look(where) {
  /** @type {Record<string, string>} */
  const native = {
    article: "article",
    button: "button, summary",
    combobox: "select",
    dialog: "dialog",
    heading: "h1, h2, h3, h4, h5, h6",
    img: "img, svg",
    link: "a[href]",
    list: "ul, ol",
    region: "section",
    slider: "input[type=range]",
    textbox: "input:not([type]), input[type=text], textarea",
  };
  /** @param {string | null | undefined} text */
  const plain = (text) => (text ?? "").replace(/\s+/g, " ").trim();

  /** @param {HTMLElement} element */
  function labelOf(element) {
    const ids = element.getAttribute("aria-labelledby")?.split(/\s+/) ?? [];
    const spoken = ids.map((id) => document.getElementById(id)?.textContent).join(" ");
    if (plain(spoken)) return plain(spoken);
    const own = element.getAttribute("aria-label");
    if (own) return plain(own);
    const { labels } = /** @type {HTMLInputElement} */ (element);
    const label = labels?.[0];
    if (label) {
      const copy = /** @type {HTMLElement} */ (label.cloneNode(true));
      for (const control of copy.querySelectorAll("select, input, textarea")) control.remove();
      return plain(copy.textContent);
    }
    return plain(element.querySelector("title")?.textContent ?? element.textContent);
  }

  /** @param {Where} wanted @returns {HTMLElement | null} */
  function find({ role, name, loosely, within }) {
    const room = within ? find(within) : document;
    if (!room) return null;
    const tags = native[role] ? `, :is(${native[role]}):not([role])` : "";
    /** @type {NodeListOf<HTMLElement>} */
    const all = room.querySelectorAll(`[role=${role}]${tags}`);
    for (const element of all) {
      if (!element.checkVisibility({ visibilityProperty: true })) continue;
      const label = name === undefined ? "" : labelOf(element);
      if (name === undefined || label === name || (loosely && label.includes(name))) return element;
    }
    return null;
  }
  return find(where);
}

/**
 * A thing in words, for messages.
 * @param {Where} where
 * @returns {string}
 */
export function inWords({ role, name, within }) {
  return `${role}${name === undefined ? "" : ` “${name}”`}${within ? ` in ${inWords(within)}` : ""}`;
}
