/**
 * What a page says to the service worker, and what it answers. Imports the parts' names.
 *
 * Every message brings a port, and gets one answer through it.
 */
import type { Part } from "./site-files.ts";

export type ToKeeper =
  /** How much is kept? */
  | { kind: "status" }
  /** Fetch what is missing of these parts, and of what the page has had from these addresses. */
  | { kind: "keep"; parts: Part[]; used: string[] }
  /** You are the new version that waits: take over. */
  | { kind: "take over" }
  /** Forget everything, and yourself. */
  | { kind: "remove" };

/** Bytes of a part that are on this device, of all its bytes. */
export interface Kept {
  have: number;
  of: number;
}

export interface KeeperStatus {
  parts: Record<Part, Kept>;
  /** Whether something is being fetched. */
  busy: boolean;
  /** Why the last fetching ended early, or null. */
  problem: string | null;
}

export type FromKeeper = { kind: "status"; status: KeeperStatus } | { kind: "done" };
