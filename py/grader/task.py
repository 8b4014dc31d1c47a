"""What a check is handed: the words in which it asks and expects.

May import: the standard library, the rest of `grader`.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from random import Random
from typing import Any

from grader.asking import NOT_SAID, Answered, Call, Look, Step
from grader.compare import Compare, exactly
from grader.declare import Check, Function, Mistake, Scoring, mistakes_of
from grader.failures import (
    AuthorError,
    CheckFailed,
    NeedsJob,
    NotRun,
    ProgramFailed,
    ShowingFailed,
)
from grader.functions import fault_text, judge_steps
from grader.jobs import Desk, Group
from grader.looping import loop_in
from grader.runs import Run
from grader.trials import Trial
from performer.values import shown

__all__ = ["Task"]

_NO_WORLD = "empty"


class Task:
    """One check at work. Calls are gathered and judged at its end; runs at once.

    random  a generator of its own: the same for the same program, another for each check
    """

    def __init__(self, check: Check, desk: Desk) -> None:
        self.random = Random(f"{check.title}:{desk.shift}:{desk.noise}")
        self._desk = desk
        self._plans: list[tuple[Group, list[Step]]] = []
        self._constants: dict[str, Any] = {}
        self._runs: list[Run] = []
        self.trials_made: list[Trial] = []

    # -- functions -----------------------------------------------------------

    def call(
        self,
        function: Function,
        *arguments: Any,
        gives: Any = NOT_SAID,
        world: str = _NO_WORLD,
        seed: int = 1,
    ) -> None:
        """Call the learner's function and compare its answer with what is right.

        gives        the answer, said outright; without it the reference says it
        world, seed  where the robot stands meanwhile, if the function uses it
        """
        if not isinstance(function, Function):
            raise AuthorError(
                "task.call(function, …) wants what function(…) made; it got " + shown(function)
            )
        most = len(function.parameters)
        if len(arguments) > most:
            raise AuthorError(
                f"{function.signature} takes {most}; task.call gives it {len(arguments)}"
            )
        constants = tuple(self._constants.items())
        self._add(Call(function, arguments, gives, constants), world, seed)

    def set(self, name: str, value: Any) -> None:
        """Run the program anew, with another value in its `name = …`, for the calls after this."""
        self._constants = {**self._constants, name: value}

    def no_loop(self, function: Function, instead: str) -> None:
        """Expect no loop in what the learner has written of a function and of what it calls.

        instead  what does its work: "NumPy works on all the points at once"
        """
        found = loop_in(self._desk.source.of(function.name))
        if found is not None:
            line, what = found
            raise CheckFailed(
                f"{function.name} without a loop: {instead}", f"line {line} has {what}"
            )

    def variable(
        self,
        name: str,
        gives: Any = NOT_SAID,
        compare: Compare = exactly,
        world: str = _NO_WORLD,
        seed: int = 1,
        mistakes: Sequence[Mistake | tuple[Any, ...]] = (),
        grid_cm: float | None = None,
    ) -> None:
        """Look at a variable of the learner's program after the calls before this.

        gives     its value; a number in it may be a `between(…)`
        mistakes  likely slips: (what the learner is told, a function of nothing that gives the
                  value which the slip would leave[, number of the hint that helps])
        grid_cm   it is a grid of cells of this side [cm]: wrong ones are named by column and row
        """
        listed = mistakes_of(mistakes, f"task.variable({name!r}, …)")
        self._add(Look(name, gives, compare, listed, grid_cm), world, seed)

    def _add(self, step: Step, world: str, seed: int) -> None:
        data = self._desk.world(world)
        at = self._desk.seed(seed)
        wanted = (data, at, self._constants)
        plan = next(
            (
                each
                for each in self._plans
                if (each[0].world, each[0].seed, each[0].constants) == wanted
            ),
            None,
        )
        if plan is None:
            plan = (Group(data, at, self._constants), [])
            self._plans.append(plan)
        plan[0].calls.append(step.request())
        plan[1].append(step)

    # -- runs ----------------------------------------------------------------

    def run(
        self,
        world: str,
        seed: int = 1,
        seconds: float = 120.0,
        mistakes: Sequence[Mistake | tuple[Any, ...]] = (),
    ) -> Run:
        """Run the learner's program, which must end by itself and without a fault.

        world     a world's name: of the lesson's own, or of bugbot
        seed      of all its noise
        seconds   simulated seconds that it may take
        mistakes  likely slips: (what the learner is told, run -> whether it looks like it[, hint])
        """
        slips = self._that_can_be(mistakes, "task.run(…)")
        run = self._run(world, seed, seconds).with_mistakes(slips)
        self._runs.append(run)
        run.must_have_ended()
        return run

    def trials(
        self,
        world: str,
        seeds: Sequence[int],
        seconds: float = 120.0,
        mistakes: Sequence[Mistake | tuple[Any, ...]] = (),
        scored: Scoring | None = None,
        free: str = "free",
        occupied: str = "occupied",
        known: float = 0.0,
    ) -> list[Trial]:
        """Run the learner's program once for each seed, to report on every run.

        world, seconds, mistakes  as for `run`
        seeds                     of each run's noise
        scored                    what a run is worth, made by scoring(…)
        free, occupied            the layers in which its map is drawn
        known                     log odds of the beams that a cell must be beyond to count as known
        """
        if not seeds or len(set(seeds)) != len(seeds):
            raise AuthorError(f"task.trials(…) wants different seeds; it got {shown(list(seeds))}")
        slips = self._that_can_be(mistakes, "task.trials(…)")
        runs = []
        wanting = 0
        for seed in seeds:
            try:
                run = self._run(world, seed, seconds)
                runs.append(run.with_mistakes(slips))
            except NeedsJob:  # the others are asked for as well: they can be made side by side
                wanting += 1
        if wanting:
            raise NeedsJob
        layers = {"free": free, "occupied": occupied}
        made = [Trial(run, layers, scored, alone=len(runs) == 1, known=known) for run in runs]
        self.trials_made += made
        return made

    def _that_can_be(
        self, mistakes: Sequence[Mistake | tuple[Any, ...]], call: str
    ) -> tuple[Mistake, ...]:
        """The mistakes that the program, as it is written, allows."""
        text = self._desk.source.of()
        return tuple(each for each in mistakes_of(mistakes, call) if each.can_be(text))

    def _run(self, world: str, seed: int, seconds: float) -> Run:
        job, result = self._desk.run(world, seed, seconds)
        key = job["id"]
        if key not in self._desk.kept:
            self._desk.kept[key] = Run.of(job, result)
        run: Run = self._desk.kept[key]
        return run

    # -- anything else -------------------------------------------------------

    def expect(
        self,
        condition: object,
        *,
        expected: str,
        got: str,
        run: Run | None = None,
        cells: Iterable[tuple[int, int]] = (),
        cell_cm: float = 5.0,
        seconds: float | None = None,
        likely: str | None = None,
        hint: int | None = None,
    ) -> None:
        """State an expectation of your own: what was expected and got, in words, and where."""
        if condition:
            return
        if run is not None:
            raise run.failure(
                expected,
                got,
                cells=cells,
                cell_cm=cell_cm,
                seconds=seconds,
                likely=likely,
                hint=hint,
            )
        raise CheckFailed(expected, got, likely=likely, hint=hint)

    def near(
        self, got: float, expected: float, within: float, what: str, run: Run | None = None
    ) -> None:
        """Expect a number, within so much; `what` names it: "the drift in degrees/s"."""
        self.expect(
            abs(got - expected) <= within,
            expected=f"{what} is {shown(round(expected, 3))}, give or take {within:g}",
            got=shown(got),
            run=run,
        )

    # -- for the judge -------------------------------------------------------

    def ask(self) -> None:
        """Have the gathered calls made."""
        for group, _ in self._plans:
            self._desk.ask(group)

    def answered(self) -> list[Answered]:
        """The calls that have been answered, with their answers; none that went wrong."""
        found: list[Answered] = []
        for group, steps in self._plans:
            reply, _ = self._desk.answers(group)
            for step, answer in zip(steps, _answers_in(reply), strict=False):
                if isinstance(step, Call) and ("value" in answer or "fault" in answer):
                    found.append((step, answer))
        return found

    def judge(self, others: Iterable[Answered]) -> None:
        """Hold the gathered calls against what is right, and the runs' maps against evidence."""
        trouble: CheckFailed | None = None
        for group, steps in self._plans:
            reply, died = self._desk.answers(group)
            answers = _answers_in(reply)
            judge_steps(steps, answers, others, group.world, self._desk.source)
            if died is not None:
                raise ProgramFailed("a program whose functions can be called", died)
            if len(answers) < len(steps) or reply.get("status") != "finished":
                failure = _cut_short(reply, group, len(answers))
                if len(answers) < len(steps):
                    raise failure
                trouble = trouble or failure
        if trouble is not None:
            raise ShowingFailed(trouble.expected, trouble.got, likely=trouble.likely)
        for run in self._runs:
            run.must_have_seen_its_maps()
        for trial in self.trials_made:
            trial.must_have_done_well()


def _answers_in(reply: Any) -> list[dict[str, Any]]:
    """The answers of one group, as far as they can be read."""
    answers = reply.get("answers") if isinstance(reply, dict) else None
    if not isinstance(answers, list):
        return []
    sound = []
    for each in answers:
        if not isinstance(each, dict) or each.get("skipped"):
            break
        # A program that stopped half-way may not have come to what the function needs.
        missed = each.get("missing")
        unknown = missed is not None and not _stopped_for_want_of(missed, reply)
        if _stopped_early(reply) and (unknown or _misses_a_name(each)):
            break
        sound.append(each)
    return sound


def _fault_in(reply: Any) -> dict[str, Any] | None:
    fault = reply.get("fault") if isinstance(reply, dict) else None
    return fault if isinstance(fault, dict) else None


def _stopped_early(reply: dict[str, Any]) -> bool:
    """Whether an error, a limit or exit() ended the program."""
    return reply.get("status") != "finished" or reply.get("left") is True


def _stopped_for_want_of(name: object, reply: dict[str, Any]) -> bool:
    """Whether the program stopped because there is nothing of this name."""
    fault = _fault_in(reply) or {}
    return fault.get("type") == "NameError" and f"'{name}'" in str(fault.get("message"))


def _misses_a_name(answer: dict[str, Any]) -> bool:
    fault = answer.get("fault")
    return isinstance(fault, dict) and fault.get("type") == "NameError"


def _cut_short(reply: Any, group: Group, answered: int) -> CheckFailed:
    """Why there are fewer answers than calls: the program never got so far."""
    garbled = ProgramFailed("answers from the program", "what came back from it was garbled")
    if not isinstance(reply, dict):
        return garbled
    if reply.get("skipped"):
        raise NotRun
    fault = _fault_in(reply)
    if fault is not None:
        return ProgramFailed(
            "a program that runs without an error", fault_text(fault), likely=fault.get("hint")
        )
    message = reply.get("message")
    if not isinstance(message, str):
        return garbled
    if reply.get("status") == "limit":
        return ProgramFailed("a program that comes to its end", message[:600])
    if reply.get("status") == "finished" and not answered:
        return ProgramFailed("a program whose functions can be called", message[:600])
    return ProgramFailed("answers to all calls", "the program was ended before it gave them")
