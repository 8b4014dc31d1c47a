"""asyncio on simulated time: sleeping lets it pass, and what has no place here says so."""

import gc
from collections.abc import Callable
from typing import Any

import pytest

Run = Callable[..., Any]


def test_sleep_lets_simulated_time_pass(run_calls: Run) -> None:
    ran = run_calls("""
        import asyncio

        async def go_on():
            forward(50)
            await asyncio.sleep(1)
            stop()

        asyncio.run(go_on())
        print(position(), clock())
    """)
    assert ran.console == "(0.0, 5.75) 1.0\n"
    assert [event["line"] for event in ran.of_kind("line")] == [6]


def test_tasks_take_turns_in_order_of_time(run_calls: Run) -> None:
    ran = run_calls("""
        import asyncio

        async def say(name, every):
            for _ in range(3):
                await asyncio.sleep(every)
                print(f"{name} {clock():g}", end=", ")
            return name

        async def main():
            print(await asyncio.gather(say("a", 0.3), say("b", 0.2)))

        asyncio.run(main())
    """)
    # At 0.6 s both are due: the one that has waited for it longer comes first.
    assert ran.console == "b 0.2, a 0.3, b 0.4, a 0.6, b 0.6, a 0.9, ['a', 'b']\n"
    assert ran.seconds == 0.9


def test_limits_of_time_are_simulated(run_calls: Run) -> None:
    ran = run_calls("""
        import asyncio

        async def main():
            try:
                await asyncio.wait_for(asyncio.sleep(60), 2)
            except TimeoutError:
                print("too late at", clock())
            try:
                async with asyncio.timeout(1):
                    await asyncio.Event().wait()
            except TimeoutError:
                print("and at", clock())
            print(asyncio.get_running_loop().time())

        asyncio.run(main())
    """)
    assert ran.console == "too late at 2.0\nand at 3.0\n3.0\n"


def test_queues_task_groups_and_cancelling_work(run_calls: Run) -> None:
    ran = run_calls("""
        import asyncio

        async def produce(queue):
            for number in range(3):
                await asyncio.sleep(0.5)
                await queue.put(number)

        async def consume(queue):
            try:
                while True:
                    print(await queue.get(), clock())
            except asyncio.CancelledError:
                print("cancelled")

        async def main():
            queue = asyncio.Queue()
            async with asyncio.TaskGroup() as group:
                consumer = group.create_task(consume(queue))
                await group.create_task(produce(queue))
                await asyncio.sleep(0)
                consumer.cancel()
            print(asyncio.current_task().get_name(), consumer.get_name())

        asyncio.run(main())
    """)
    assert ran.console == "0 0.5\n1 1.0\n2 1.5\ncancelled\nTask-1 Task-2\n"


def test_the_old_way_of_running_a_loop_works(run_calls: Run) -> None:
    ran = run_calls("""
        import asyncio
        loop = asyncio.get_event_loop()
        loop.call_later(0.5, print, "later")
        loop.run_until_complete(asyncio.sleep(1))
        other = asyncio.new_event_loop()
        asyncio.set_event_loop(other)
        other.run_until_complete(asyncio.sleep(1))
        print(loop is not other, asyncio.get_event_loop() is other, clock())
    """)
    assert ran.console == "later\nTrue True 2.0\n"


def test_the_same_program_leaves_the_same_trace(run_calls: Run) -> None:
    program = """
        import asyncio
        async def look(n):
            for _ in range(5):
                await asyncio.sleep(n / 10)
                print(n, scan(), asyncio.current_task().get_name())
        async def main():
            await asyncio.gather(*map(look, range(1, 5)))
        asyncio.run(main())
    """
    assert run_calls(program).trace.events == run_calls(program).trace.events


@pytest.mark.parametrize(
    ("awaited", "message"),
    [
        (
            "asyncio.get_running_loop().create_future()",
            "the program waits on line 3 for something that can't come",
        ),
        ("asyncio.Event().wait()", "the program waits on line 3 for something that can't come"),
        ("asyncio.open_connection('example.com', 80)", "a program here has no network"),
        ("asyncio.create_subprocess_exec('ls')", "a program here has no network and starts no"),
        ("asyncio.to_thread(print, 1)", "a program can't start threads, and to_thread()"),
    ],
)
def test_what_can_not_be_is_told(run: Run, awaited: str, message: str) -> None:
    ran = run(f"import asyncio\nasync def main():\n    await {awaited}\nasyncio.run(main())")
    assert ran.status == "fault"
    assert message in ran.fault["message"]


def test_an_error_in_a_task_is_told_on_its_line(run: Run) -> None:
    ran = run("""
        import asyncio
        async def main():
            await asyncio.sleep(1)
            return 1 / 0
        asyncio.run(main())
    """)
    assert (ran.fault["type"], ran.fault["line"], ran.seconds) == ("ZeroDivisionError", 4, 1.0)


def test_an_error_that_nobody_asks_for_is_written(run: Run) -> None:
    ran = run("""
        import asyncio, gc
        async def fail():
            raise KeyError("lost")
        async def main():
            asyncio.create_task(fail())
            await asyncio.sleep(1)
            gc.collect()
        asyncio.run(main())
    """)
    assert ran.console == "Task exception was never retrieved: KeyError: 'lost'\n"


def test_a_loop_left_open_is_no_warning_of_the_hosts(run: Run) -> None:
    ran = run("import asyncio\nasyncio.new_event_loop()\nprint('done')")
    gc.collect()
    assert (ran.status, ran.console) == ("finished", "done\n")
