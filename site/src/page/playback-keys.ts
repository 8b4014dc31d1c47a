/**
 * Space plays and pauses, the arrows step: wherever the picture or the playback bar has the focus,
 * unless what has it needs the key for itself. May import `player`.
 */
import type { Player } from "../player/player.ts";

export function playbackKey(event: KeyboardEvent, player: Player): void {
  if (event.defaultPrevented || event.altKey || event.ctrlKey || event.metaKey) return;
  const { target } = event;
  const isControl =
    target instanceof Element && target.closest("button, select, input, a, summary") !== null;
  if (event.key === " " && !isControl) player.toggle();
  else if (event.key === "ArrowRight" && !isField(target)) player.step(1);
  else if (event.key === "ArrowLeft" && !isField(target)) player.step(-1);
  else return;
  event.preventDefault();
}

/** On the time slider: the arrows step as well, and the page keys go by tenths of the run. */
export function sliderKey(event: KeyboardEvent, player: Player): void {
  const tenth = player.duration / 10;
  const moves: Record<string, () => void> = {
    ArrowRight: () => player.step(1),
    ArrowUp: () => player.step(1),
    ArrowLeft: () => player.step(-1),
    ArrowDown: () => player.step(-1),
    PageUp: () => player.seek(player.time + tenth),
    PageDown: () => player.seek(player.time - tenth),
    Home: () => player.toStart(),
    End: () => player.toEnd(),
    " ": () => player.toggle(),
  };
  const move = moves[event.key];
  if (!move || event.altKey || event.ctrlKey || event.metaKey) return;
  move();
  event.preventDefault();
}

function isField(target: EventTarget | null): boolean {
  return target instanceof Element && target.closest("select, input") !== null;
}
