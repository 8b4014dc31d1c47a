/**
 * The run-time interface of SCORM 1.2, as far as a lesson uses it: finding the platform's object,
 * and talking with it in texts. Imports nothing of ours.
 */

/** What a platform puts into a window of its own for the lesson to find. */
interface PlatformApi {
  LMSInitialize(nothing: ""): string | boolean;
  LMSGetValue(name: string): string;
  LMSSetValue(name: string, value: string): string | boolean;
  LMSCommit(nothing: ""): string | boolean;
  LMSFinish(nothing: ""): string | boolean;
  LMSGetLastError(): string;
}

/** The standard lets a platform lie so many frames further out, and no more. */
const MOST_FRAMES = 7;

/** The platform's object: in a frame around this one, or in the window that opened it. */
export function findApi(from: Window): PlatformApi | null {
  const inFrames = searchFrames(from);
  if (inFrames) return inFrames;
  try {
    return from.opener ? searchFrames(from.opener as Window) : null;
  } catch {
    return null;
  }
}

function searchFrames(from: Window): PlatformApi | null {
  let place = from;
  for (let frames = 0; frames <= MOST_FRAMES; frames += 1) {
    try {
      const { API } = place as Window & { API?: PlatformApi };
      if (API && typeof API.LMSInitialize === "function") return API;
    } catch {
      // A window of another site: no platform of ours, and no way through it is lost.
    }
    if (place.parent === place) return null;
    place = place.parent;
  }
  return null;
}

/** One session with a platform: from the start of a lesson's page to its end. */
export class Session {
  readonly #api: PlatformApi;
  readonly #began: number;
  #over = false;

  private constructor(api: PlatformApi, now: number) {
    this.#api = api;
    this.#began = now;
  }

  /** Null if no platform is there, or it refuses. */
  static begin(from: Window, now: number): Session | null {
    const api = findApi(from);
    if (!api || !isTrue(api.LMSInitialize(""))) return null;
    return new Session(api, now);
  }

  get(name: string): string {
    const value = String(this.#api.LMSGetValue(name) ?? "");
    return this.#api.LMSGetLastError() === "0" || value !== "" ? value : "";
  }

  /** Sets these values and has the platform keep them. */
  set(values: Record<string, string>): void {
    if (this.#over) return;
    for (const [name, value] of Object.entries(values)) this.#api.LMSSetValue(name, value);
    this.#api.LMSCommit("");
  }

  /** Ends the session; nothing can be said after it. */
  finish(now: number): void {
    if (this.#over) return;
    this.set({
      "cmi.core.session_time": sessionTime((now - this.#began) / 1000),
      // The next visit goes on from here, finished or not.
      "cmi.core.exit": "suspend",
    });
    this.#over = true;
    this.#api.LMSFinish("");
  }
}

/** Seconds as SCORM writes them: HHHH:MM:SS.SS. */
export function sessionTime(seconds: number): string {
  const hundredths = Math.max(0, Math.round(seconds * 100));
  const pad = (value: number, digits: number) => String(value).padStart(digits, "0");
  const whole = Math.floor(hundredths / 100);
  const [hours, minutes] = [Math.floor(whole / 3600), Math.floor(whole / 60) % 60];
  return `${pad(hours, 4)}:${pad(minutes, 2)}:${pad(whole % 60, 2)}.${pad(hundredths % 100, 2)}`;
}

function isTrue(answer: string | boolean): boolean {
  return answer === true || answer === "true";
}
