"""Probability against log odds, with a hit, a pass, and the clamp."""

from mapping.log_odds import L_FREE, L_MAX, L_OCC, probability
from sketch import Drawing

WIDEST = 10.0


def picture() -> str:
    drawing = Drawing(
        340,
        226,
        "Log odds and probability",
        "A curve like a long S. Log odds run from -10 to 10 across, probability from 0 to 1 up. "
        "At 0 the probability is a half. It is steep there: one hit, 0.85, goes up to 0.7, and "
        "one pass, -0.4, down to 0.4. Beyond 4 on either side it is almost flat. At -8 and 8 "
        "the clamp begins.",
    )
    chart = drawing.plane(
        38, 16, scale=14.6, scale_y=160, width_cm=2 * WIDEST, height_cm=1, origin=(-WIDEST, 0)
    )
    for left in (-WIDEST, L_MAX):
        chart.rectangle((left, 0), WIDEST - L_MAX, 1, "band-2")
    for p in (0.0, 0.5, 1.0):
        chart.line((-WIDEST, p), (WIDEST, p), "axis" if p == 0 else "guide")
        chart.text((-WIDEST, p), f"{p:g}", "soft end small", down=4)
    chart.line((0, 0), (0, 1), "guide")
    for mark in (-L_MAX, -4, 0, 4, L_MAX):
        chart.text((mark, 0), f"{mark:g}".replace("-", "−"), "soft middle small", down=16)
    points = [i / 5 for i in range(round(-5 * WIDEST), round(5 * WIDEST) + 1)]
    chart.curve([(each, probability(each)) for each in points])
    for limit in (-L_MAX, L_MAX):
        chart.line((limit, 0), (limit, 1), "axis")
    for log_odds, words, kind, down in (
        (L_OCC, "one hit", "ink", 5.0),
        (0.0, "unknown", "ink", 16.0),
        (L_FREE, "one pass", "ink end", -2.0),
    ):
        chart.dot((log_odds, probability(log_odds)), 4, "step")
        side = 0.7 if kind == "ink" else -0.7
        chart.text((log_odds + side, probability(log_odds)), words, kind, down=down)
    chart.text((-L_MAX + 0.3, 0.9), "clamp", "soft small")
    chart.text((L_MAX - 0.3, 0.1), "clamp", "soft small end")
    drawing.text(184, 220, "log odds l", "ink middle")
    drawing.text(5, 12, "p", "ink strong")
    return drawing.svg()
