/**
 * The robot and what it did: its way, its beams, its light, its bumps.
 * May import `trace` and, in this folder, `camera` and `palette`.
 */
import type { Bump, Led, Pose, Scan } from "../../trace/events.ts";
import { direction, ROBOT_RADIUS_CM, SENSOR_RANGE_CM } from "../../trace/frames.ts";
import type { Camera } from "./camera.ts";
import type { Palette } from "./palette.ts";

export function paintTrail(
  ctx: CanvasRenderingContext2D,
  camera: Camera,
  palette: Palette,
  trail: Float64Array,
) {
  ctx.strokeStyle = palette.robot;
  ctx.globalAlpha = 0.45;
  ctx.lineWidth = camera.px(2);
  ctx.lineCap = ctx.lineJoin = "round";
  ctx.beginPath();
  for (let i = 0; i < trail.length; i += 2) {
    ctx.lineTo(camera.x(trail[i] as number), camera.y(trail[i + 1] as number));
  }
  ctx.stroke();
  ctx.globalAlpha = 1;
}

/** A beam that found something ends in a dot; one that found nothing is dashed and has no end. */
export function paintBeams(
  ctx: CanvasRenderingContext2D,
  camera: Camera,
  palette: Palette,
  scan: Scan,
) {
  ctx.strokeStyle = palette.robot;
  ctx.lineWidth = camera.px(1.25);
  for (let i = 0; i < scan.beams.length; i += 2) {
    const [right, up] = direction(scan.heading + (scan.beams[i] as number));
    const cm = scan.beams[i + 1] as number;
    const found = cm < SENSOR_RANGE_CM;
    const endX = camera.x(scan.x + cm * right);
    const endY = camera.y(scan.y + cm * up);
    ctx.globalAlpha = found ? 0.6 : 0.35;
    ctx.setLineDash(found ? [] : [camera.px(3), camera.px(4)]);
    ctx.beginPath();
    ctx.moveTo(camera.x(scan.x), camera.y(scan.y));
    ctx.lineTo(endX, endY);
    ctx.stroke();
    if (!found) continue;
    ctx.globalAlpha = 1;
    disc(ctx, endX, endY, camera.px(2.75), palette.nose);
    disc(ctx, endX, endY, camera.px(1.75), palette.robot);
  }
  ctx.setLineDash([]);
  ctx.globalAlpha = 1;
}

/** A disc with an arrowhead for its heading; its light is a ring around it. */
export function paintRobot(
  ctx: CanvasRenderingContext2D,
  camera: Camera,
  palette: Palette,
  pose: Pose,
  led: Led | null,
) {
  const radius = ROBOT_RADIUS_CM * camera.scale;
  const x = camera.x(pose.x);
  const y = camera.y(pose.y);
  const lit = led !== null && led.red + led.green + led.blue > 0;
  if (lit) {
    const glow = radius + camera.px(4);
    disc(ctx, x, y, glow + camera.px(1), palette.nose);
    disc(ctx, x, y, glow, `rgb(${led.red} ${led.green} ${led.blue})`);
  }
  disc(ctx, x, y, radius + camera.px(1), palette.nose);
  disc(ctx, x, y, radius, palette.robot);
  const [right, up] = direction(pose.heading);
  const at = (ahead: number, aside: number) => {
    ctx.lineTo(
      x + radius * (ahead * right + aside * up),
      y - radius * (ahead * up - aside * right),
    );
  };
  ctx.beginPath();
  at(0.78, 0);
  at(-0.46, 0.56);
  at(-0.2, 0);
  at(-0.46, -0.56);
  ctx.fillStyle = palette.nose;
  ctx.fill();
}

/** A note beside the robot while its tone sounds. */
export function paintNote(
  ctx: CanvasRenderingContext2D,
  camera: Camera,
  palette: Palette,
  pose: Pose,
) {
  ctx.font = `${camera.px(18)}px ${palette.font}`;
  ctx.textAlign = "left";
  ctx.textBaseline = "bottom";
  ctx.fillStyle = palette.robot;
  const away = ROBOT_RADIUS_CM * camera.scale;
  ctx.fillText("♪", camera.x(pose.x) + away, camera.y(pose.y) - away);
}

/** A small cross wherever the robot touched something. */
export function paintBumps(
  ctx: CanvasRenderingContext2D,
  camera: Camera,
  palette: Palette,
  bumps: readonly Bump[],
) {
  const arm = camera.px(3.5);
  ctx.beginPath();
  for (const bump of bumps) {
    const x = camera.x(bump.x);
    const y = camera.y(bump.y);
    ctx.moveTo(x - arm, y - arm);
    ctx.lineTo(x + arm, y + arm);
    ctx.moveTo(x - arm, y + arm);
    ctx.lineTo(x + arm, y - arm);
  }
  ctx.lineCap = "round";
  for (const [colour, width] of [
    [palette.nose, 4],
    [palette.bump, 2],
  ] as const) {
    ctx.strokeStyle = colour;
    ctx.lineWidth = camera.px(width);
    ctx.stroke();
  }
}

function disc(ctx: CanvasRenderingContext2D, x: number, y: number, radius: number, colour: string) {
  ctx.fillStyle = colour;
  ctx.beginPath();
  ctx.arc(x, y, radius, 0, 2 * Math.PI);
  ctx.fill();
}
