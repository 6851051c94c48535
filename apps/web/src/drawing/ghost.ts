import type { Pose, RobotConfig } from '@botgarten/simulation'
import { drawBo } from './bo.ts'
import { onFloor } from './camera.ts'
import { greyOf } from './colours.ts'
import type { Command } from './commands.ts'
import type { Size } from './points.ts'

/** Where Bo does not stand now. */
export interface Ghost {
  readonly config: RobotConfig
  readonly pose: Pose
  readonly label: string
  /** Of the label's letters, in px. */
  readonly labelWidth: number
  /** A shade of grey: it stood there. Otherwise pale: it would stand there. */
  readonly grey: boolean
}

const ink = '#3A2A20'
const edge = '#8C7152'

const greyInk = (ink: string | undefined) => (ink?.startsWith('#') ? greyOf(ink) : ink)

const inGrey = (command: Command): Command => ({
  ...command,
  ...(command.kind === 'group' ? { shapes: command.shapes.map(inGrey) } : {}),
  ...('fill' in command ? { fill: greyInk(command.fill)! } : {}),
  ...('stroke' in command ? { stroke: greyInk(command.stroke)! } : {}),
})

const ghosts = new WeakMap<RobotConfig, readonly Command[]>()

function ghostLook(config: RobotConfig, grey: boolean): readonly Command[] {
  const look = ghosts.get(config) ?? drawBo({ config, led: null, text: false })
  ghosts.set(config, look)
  return grey ? look.map(inGrey) : look
}

/** Bo where it does not stand now, and why. */
export function drawGhost(
  { config, pose, label, labelWidth, grey }: Ghost,
  { floor, scale }: { readonly floor: Size; readonly scale: number },
): readonly Command[] {
  const at = onFloor(pose, floor, scale)
  const top = at.y + 13 * scale + 2
  const width = labelWidth + 28
  return [
    ...(grey ? [] : [{ kind: 'circle' as const, ...at, r: 12.5 * scale, fill: edge, opacity: 0.22 }]),
    {
      kind: 'group',
      ...at,
      turn: 90 - pose.heading,
      scale,
      opacity: grey ? 0.35 : 0.5,
      shapes: ghostLook(config, grey),
    },
    {
      kind: 'rect',
      x: at.x - width / 2,
      y: top,
      width,
      height: 24,
      round: 11,
      fill: '#FFFDF8',
      stroke: edge,
      lineWidth: 2,
      dash: [5, 4],
    },
    { kind: 'text', x: at.x, y: top + 17, text: label, size: 14.5, font: 'read', align: 'middle', fill: ink },
  ]
}
