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
  expect(storage.length).toBe(0);
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
