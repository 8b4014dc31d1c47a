/** What is kept of a program, and what happens where the device keeps nothing. */
import { expect, test } from "@playwright/test";
import { KeptProgram, ProgramStore } from "../../site/src/page/storage.ts";

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
