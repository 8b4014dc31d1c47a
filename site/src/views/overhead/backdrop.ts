/**
 * Something under the program's own layers that is none of them, such as a map from a file. It
 * paints itself; whoever made it knows what it is. May import `camera`.
 */
import type { Camera } from "./camera.ts";

export interface Backdrop {
  /** As the legend names it. */
  name: string;
  /** What it is, in a few words. */
  note: string;
  /** What else there is to know of it, in sentences. */
  more: string;
  paint(ctx: CanvasRenderingContext2D, camera: Camera): void;
  onRemove(): void;
}
