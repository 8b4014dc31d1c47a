/**
 * The run-time interface of SCORM 1.2, as far as a lesson uses it: finding the platform's object,
 * and talking with it in texts. Imports nothing of ours.
 */

/** What a platform puts into a window of its own for the lesson to find. Any call may be missing. */
type PlatformApi = Partial<Record<CallName, (name: string, value?: string) => unknown>>;

type CallName = "LMSInitialize" | "LMSGetValue" | "LMSSetValue" | "LMSCommit" | "LMSFinish";

/** What platforms say that mean nothing. */
const NO_VALUES = ["null", "undefined", "false"];

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
      if (API && (isCall(API.LMSInitialize) || isCall(API.LMSSetValue))) return API;
    } catch {
      // A window of another site: no platform of ours, and no way through it is lost.
    }
    if (place.parent === place) return null;
    place = place.parent;
  }
  return null;
}

/**
 * One session with a platform: from the start of a lesson's page to its end. A platform's call that is
 * missing or throws is passed over: whatever else can be said is said, and the session is finished.
 */
export class Session {
  readonly #api: PlatformApi;
  readonly #began: number;
  #over = false;

  private constructor(api: PlatformApi, now: number) {
    this.#api = api;
    this.#began = now;
  }

  /** Null if no platform is there. One that refuses is there: it has a learner, and other learners. */
  static begin(from: Window, now: number): Session | null {
    const api = findApi(from);
    if (!api) return null;
    const session = new Session(api, now);
    // Some have begun it themselves, and say false; whatever it says, what follows is worth a try.
    session.#call("LMSInitialize", "");
    return session;
  }

  /** A value; "" where the platform has none, or does not say. */
  get(name: string): string {
    const value = String(this.#call("LMSGetValue", name) ?? "");
    return NO_VALUES.includes(value) ? "" : value;
  }

  /** Sets these values and has the platform keep them. */
  set(values: Record<string, string>): void {
    if (this.#over) return;
    for (const [name, value] of Object.entries(values)) this.#call("LMSSetValue", name, value);
    this.#call("LMSCommit", "");
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
    this.#call("LMSFinish", "");
  }

  /** What the platform answers; null if it can't be asked. */
  #call(name: CallName, ...values: [name: string, value?: string]): unknown {
    try {
      // By the object: a platform's calls may use it.
      return this.#api[name]?.(...values) ?? null;
    } catch (error) {
      console.info(`The platform's ${name} has failed:`, error);
      return null;
    }
  }
}

function isCall(value: unknown): value is (name: string, value?: string) => unknown {
  return typeof value === "function";
}

/** Seconds as SCORM writes them: HHHH:MM:SS.SS. */
export function sessionTime(seconds: number): string {
  const hundredths = Math.max(0, Math.round(seconds * 100));
  const pad = (value: number, digits: number) => String(value).padStart(digits, "0");
  const whole = Math.floor(hundredths / 100);
  const [hours, minutes] = [Math.floor(whole / 3600), Math.floor(whole / 60) % 60];
  return `${pad(hours, 4)}:${pad(minutes, 2)}:${pad(whole % 60, 2)}.${pad(hundredths % 100, 2)}`;
}
