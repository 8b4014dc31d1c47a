/** What is kept of a program, and what happens where the device keeps nothing. */
import { expect, test } from "@playwright/test";
import { KeptProgram } from "../../site/src/page/kept-program.ts";
import { ProgramStore } from "../../site/src/page/storage.ts";

const STARTER = "print('start')\n";

function memory(): Storage {
  const items = new Map<string, string>();
  return {
    getItem: (key) => items.get(key) ?? null,
    setItem: (key, value) => void items.set(key, value),
    removeItem: (key) => void items.delete(key),
    clear: () => items.clear(),
    key: (index) => [...items.keys()][index] ?? null,
    get length() {
      return items.size;
    },
  };
}

function refusing(): Storage {
  throw new DOMException("forbidden", "SecurityError");
}

test("typed text is kept at once on leaving, under its own key", () => {
  const storage = memory();
  const store = new ProgramStore(() => storage);
  const kept = new KeptProgram(store, "lab:doorway", STARTER, () => {});
  kept.changed("mine");
  kept.flush();
  expect(new KeptProgram(store, "lab:doorway", STARTER, () => {}).load()).toBe("mine");
  expect(new KeptProgram(store, "lab:empty", STARTER, () => {}).load()).toBeNull();
});

test("an untouched starter is not kept, so a better one is seen", () => {
  const storage = memory();
  const kept = new KeptProgram(new ProgramStore(() => storage), "lab", STARTER, () => {});
  kept.changed("mine");
  kept.flush();
  kept.changed(STARTER);
  kept.flush();
  expect(storage.getItem("bugbot:program:lab")).toBeNull();
  expect(storage.getItem("bugbot:starter:lab")).toBeNull();
  // What was typed and has never run is a version.
  expect(kept.versions().map(({ text }) => text)).toEqual(["mine"]);
});

const TYPED = Array.from({ length: 20 }, (_, i) => `print("line ${i}")\n`).join("");

/** As somebody types: one sign after the other. */
function type(kept: KeptProgram, text: string, from = ""): void {
  for (let i = 1; i <= text.length; i++) kept.changed(from + text.slice(0, i));
}

const texts = (kept: KeptProgram): string[] => kept.versions().map(({ text }) => text);

test("what was typed and never run is a version before it is deleted, or replaced by something longer", () => {
  for (const after of ["", "\n", "x", `${TYPED.replaceAll("line", "other line")}# and more\n`]) {
    const storage = memory();
    const store = new ProgramStore(() => storage);
    const kept = new KeptProgram(store, "lab", STARTER, () => {});
    type(kept, TYPED);
    kept.changed(after);
    kept.flush();
    expect(texts(new KeptProgram(store, "lab", STARTER, () => {})), after).toContain(TYPED);
  }
});

test("a short program too, and one that goes letter by letter", () => {
  for (const text of ["x = 1", TYPED]) {
    const storage = memory();
    const kept = new KeptProgram(new ProgramStore(() => storage), "lab", STARTER, () => {});
    type(kept, text);
    for (let i = text.length - 1; i >= 0; i--) kept.changed(text.slice(0, i));
    kept.flush();
    expect(texts(kept)).toContain(text);
    // Not one for each letter.
    expect(texts(kept).length).toBeLessThan(15);
  }
});

test("typing, and correcting what one types, makes no versions", () => {
  const storage = memory();
  const kept = new KeptProgram(new ProgramStore(() => storage), "lab", STARTER, () => {});
  kept.changed(`${STARTER}\n`);
  type(kept, TYPED, `${STARTER}\n`);
  let text = `${STARTER}\n${TYPED}`;
  for (let i = 0; i < 60; i++) {
    for (const typed of ["fo", "for", "fo", "f"]) kept.changed(text + typed);
    text += "x";
    kept.changed(text);
  }
  kept.flush();
  expect(texts(kept)).toEqual([]);
});

test("who types without a pause has it kept once a second", async () => {
  const storage = memory();
  const kept = new KeptProgram(new ProgramStore(() => storage), "lab", STARTER, () => {});
  const timers: { work: () => void; at: number }[] = [];
  const [set, clear] = [globalThis.setTimeout, globalThis.clearTimeout];
  let now = 0;
  globalThis.setTimeout = ((work: () => void, ms: number) => {
    timers.push({ work, at: now + ms });
    return timers.length as unknown as ReturnType<typeof setTimeout>;
  }) as typeof setTimeout;
  globalThis.clearTimeout = ((id: number) => {
    if (id) timers[id - 1] = { work: () => {}, at: Number.POSITIVE_INFINITY };
  }) as typeof clearTimeout;
  try {
    for (let i = 1; i <= 400; i++) {
      now = i * 20;
      for (const timer of timers.filter(({ at }) => at <= now)) {
        timer.at = Number.POSITIVE_INFINITY;
        timer.work();
      }
      kept.changed("x".repeat(i), now);
    }
  } finally {
    [globalThis.setTimeout, globalThis.clearTimeout] = [set, clear];
  }
  // 8 s of typing: of the last second nothing need be there yet.
  expect(storage.getItem("bugbot:program:lab")?.length).toBeGreaterThanOrEqual(350);
});

test("two tabs that type the same program in turn lose nothing, and do not flood the versions", () => {
  const storage = memory();
  const tab = () => new KeptProgram(new ProgramStore(() => storage), "lab", STARTER, () => {});
  const [one, two] = [tab(), tab()];
  const first = "print('the first tab says this')\n";
  const second = "print('and the second says that')\n";
  for (let i = 1; i <= first.length || i <= second.length; i++) {
    one.changed(first.slice(0, i));
    one.flush();
    two.changed(second.slice(0, i));
    two.flush();
  }
  one.changed(`${first}# goes on\n`);
  one.flush();
  const all = [...texts(one), one.load()];
  expect(all).toContain(second);
  expect(all).toContain(`${first}# goes on\n`);
  expect(texts(one).length).toBeLessThan(8);
});

test("a starter that has changed since never replaces the learner's work", () => {
  const storage = memory();
  const store = new ProgramStore(() => storage);
  const before = new KeptProgram(store, "lab", STARTER, () => {});
  before.changed("mine");
  before.flush();
  expect(new KeptProgram(store, "lab", "print('a better start')\n", () => {}).load()).toBe("mine");
});

test("where storage is refused nothing throws, and the page is told", () => {
  let refusals = 0;
  const store = new ProgramStore(refusing);
  const kept = new KeptProgram(store, "lab", STARTER, () => {
    refusals += 1;
  });
  expect(kept.load()).toBeNull();
  kept.changed("mine");
  kept.flush();
  kept.changed(STARTER);
  kept.flush();
  expect(refusals).toBe(1);
});

test("where storage is refused the program and its versions last as long as the page", () => {
  const store = new ProgramStore(refusing);
  const kept = new KeptProgram(store, "lab", STARTER, () => {});
  kept.changed("mine");
  kept.flush();
  for (let i = 0; i < 5; i++) kept.putAside(`version ${i}`, i);
  expect(new KeptProgram(store, "lab", STARTER, () => {}).load()).toBe("mine");
  expect(kept.versions().map(({ at }) => at)).toEqual([4, 3, 2, 1, 0]);
});

test("on a full device the newest versions are kept", () => {
  const storage = memory();
  const keep = storage.setItem;
  storage.setItem = (key, value) => {
    if (value.length > 150) throw new DOMException("full", "QuotaExceededError");
    keep(key, value);
  };
  const kept = new KeptProgram(new ProgramStore(() => storage), "lab", STARTER, () => {});
  for (let i = 0; i < 8; i++) kept.putAside(`version ${i}`, i);
  const again = new KeptProgram(new ProgramStore(() => storage), "lab", STARTER, () => {});
  const times = again.versions().map(({ at }) => at);
  expect(times.slice(0, 2)).toEqual([7, 6]);
  expect(times.length).toBeLessThan(8);
});

test("the starter and an empty program are no versions", () => {
  const kept = new KeptProgram(new ProgramStore(memory), "lab", STARTER, () => {});
  kept.putAside(STARTER);
  kept.putAside("  \n");
  expect(kept.versions()).toEqual([]);
});

test.describe("a starter that has changed", () => {
  const NEWER = "print('a better start')\n";
  const begun = () => {
    const storage = memory();
    const store = new ProgramStore(() => storage);
    const kept = new KeptProgram(store, "lab", STARTER, () => {});
    kept.changed("mine");
    kept.flush();
    return store;
  };

  test("is known, until the learner has answered", () => {
    const store = begun();
    expect(new KeptProgram(store, "lab", STARTER, () => {}).outgrown).toBe(false);
    const newer = new KeptProgram(store, "lab", NEWER, () => {});
    expect(newer.outgrown).toBe(true);
    newer.beginsHere();
    expect(new KeptProgram(store, "lab", NEWER, () => {}).outgrown).toBe(false);
  });

  test("is still known after more has been written", () => {
    const store = begun();
    const newer = new KeptProgram(store, "lab", NEWER, () => {});
    newer.changed("mine, further");
    newer.flush();
    expect(new KeptProgram(store, "lab", NEWER, () => {}).outgrown).toBe(true);
  });
});

test("what another tab kept goes into the versions before it is written over", () => {
  const storage = memory();
  const tab = () => new KeptProgram(new ProgramStore(() => storage), "lab", STARTER, () => {});
  const [one, two] = [tab(), tab()];
  one.changed("of one");
  one.flush();
  two.changed("of two");
  two.flush();
  expect(tab().load()).toBe("of two");
  expect(
    tab()
      .versions()
      .map(({ text }) => text),
  ).toEqual(["of one"]);
  one.changed(STARTER);
  one.flush();
  expect(tab().load()).toBeNull();
  expect(
    tab()
      .versions()
      .map(({ text }) => text),
  ).toEqual(["of two", "of one"]);
});
