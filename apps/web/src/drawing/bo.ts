import type { LedColour, RobotConfig, SensorPlace, SensorPort } from '@botgarten/simulation'
import type { Command, Ink } from './commands.ts'
import { clamp, distance, type Point } from './points.ts'
import { clockwise } from './things.ts'

/** A part that can be pointed at and lights up with its block and its node: `motor C`, `sensor 2`, `lamp`. */
export interface Part extends Point {
  readonly part: string
  /** From its middle, in cm. */
  readonly radius: number
}

export interface BoLook {
  readonly config: RobotConfig
  readonly led: LedColour | null
  /** Does its display show anything? */
  readonly text: boolean
  /** Of its body. */
  readonly colour?: string | undefined
  readonly lights?: (part: string) => boolean
}

const line: Ink = { stroke: '#4A3428', lineWidth: 0.7 }
/** Colours of a lamp that shines. */
export const lamps: { readonly [colour in LedColour]: string } = {
  green: '#2FB457',
  orange: '#FFA51F',
  red: '#F0392B',
}
const wheelWidth = 2.8
/** Where the lamp sits behind Bo's middle, in cm. */
export const lampAt = 4.3

/** Where a wheel's left edge is, and its part. */
const wheelsOf = ({ trackWidth, drive }: RobotConfig) => [
  { x: 0 - trackWidth / 2 - wheelWidth / 2, part: `motor ${drive.left}` },
  { x: trackWidth / 2 - wheelWidth / 2, part: `motor ${drive.right}` },
]

const isEye = ({ kind }: SensorPlace) => kind === 'ultrasonic' || kind === 'infrared'

const sensorsOf = ({ sensors }: RobotConfig) => Object.entries(sensors) as [SensorPort, SensorPlace][]

// Sensors may be said to sit on the edge; drawn they stay on the head.
const eyeAt = ({ x, y }: SensorPlace): Point => ({ x: clamp(0 - y, -4.2, 4.2), y: clamp(0 - x, -6.55, 5.2) })

const floorEyeOf = (config: RobotConfig) => sensorsOf(config).find(([, { kind }]) => kind === 'colour')?.[0]

/** The parts of Bo that can be pointed at, in cm from its middle, its front up. */
export function partsOf(config: RobotConfig): readonly Part[] {
  const floorEye = floorEyeOf(config)
  return [
    ...wheelsOf(config).map(({ x, part }) => ({ part, x: x + wheelWidth / 2, y: 0, radius: wheelWidth / 2 })),
    ...sensorsOf(config).flatMap(([port, sensor]) =>
      isEye(sensor) ? [{ part: `sensor ${port}`, ...eyeAt(sensor), radius: 2.25 }] : [],
    ),
    ...(floorEye === undefined ? [] : [{ part: `sensor ${floorEye}`, x: 0, y: -5, radius: 0.95 }]),
    { part: 'lamp', x: 0, y: lampAt, radius: 1.3 },
  ]
}

// Px around a part that a fingertip covers.
const reach = 14

/**
 * The part nearest to a point, not further than a fingertip; else null.
 * @param at px from Bo's middle, its front up
 * @param scale px per cm
 */
export function partAt(config: RobotConfig, scale: number, at: Point): string | null {
  const near = partsOf(config)
    .map(({ part, x, y, radius }) => ({
      part,
      away: distance({ x: x * scale, y: y * scale }, at),
      radius: radius * scale,
    }))
    .filter(({ away, radius }) => away <= reach + radius)
    .sort((a, b) => a.away - b.away)
  return near[0]?.part ?? null
}

const halo = ({ x, y }: Point): Command => ({
  kind: 'circle',
  x,
  y,
  r: 5.4,
  fill: '#FFC83D',
  stroke: '#fff',
  lineWidth: 1.2,
})

const outline =
  'M-3.3-9.4H3.3C5.5-9.4 6.65-7.2 6.65-5.2V2C6.65 4.9 4.8 6.7 2 6.7H-2C-4.8 6.7-6.65 4.9-6.65 2V-5.2C-6.65-7.2-5.5-9.4-3.3-9.4Z'
const body =
  'M-3.3-8.6H3.3C5.5-8.6 6.65-7.4 6.65-5.2V2C6.65 4.9 4.8 6.7 2 6.7H-2C-4.8 6.7-6.65 4.9-6.65 2V-5.2C-6.65-7.4-5.5-8.6-3.3-8.6Z'

const shell = (colour: string): readonly Command[] => [
  { kind: 'path', d: body, fill: colour, ...line },
  {
    kind: 'path',
    d: 'M6.65-3V2C6.65 4.9 4.8 6.7 2 6.7H.2C3.6 5.4 4.9 2 4.9-3.3z',
    fill: 'rgb(122 46 12 / 0.16)',
  },
  {
    kind: 'path',
    d: 'M-3.3-8.6H3.3C5.5-8.6 6.65-7.4 6.65-5.2V-3.7H-6.65V-5.2C-6.65-7.4-5.5-8.6-3.3-8.6Z',
    fill: '#FFEBCB',
    ...line,
  },
  {
    kind: 'path',
    d: 'M-5.7-9C-4-10.15 4-10.15 5.7-9L5.3-8.25C3.6-9-3.6-9-5.3-8.25Z',
    fill: '#8A6A52',
    ...line,
    lineWidth: 0.6,
  },
]

function wheels({ config, lights }: BoLook): readonly Command[] {
  const half = config.wheelDiameter / 2
  return wheelsOf(config).flatMap(({ x, part }): Command[] => [
    ...(lights?.(part) ? [halo({ x: x + wheelWidth / 2, y: 0 })] : []),
    {
      kind: 'rect',
      x,
      y: 0 - half,
      width: wheelWidth,
      height: 2 * half,
      round: 1.1,
      fill: '#5B4436',
      ...line,
    },
    {
      kind: 'path',
      d: `M${x + 0.6}-1.7h1.6M${x + 0.6}-.55h1.6M${x + 0.6} .6h1.6M${x + 0.6} 1.75h1.6`,
      stroke: '#3A2A20',
      lineWidth: 0.42,
    },
  ])
}

const dot = (x: number, y: number, r: number, lineWidth: number): Command => ({
  ...{ kind: 'circle', x, y, r, fill: '#fff' },
  ...line,
  lineWidth,
})

const eyes = ({ config, lights }: BoLook): readonly Command[] =>
  sensorsOf(config).flatMap(([port, sensor]): Command[] => {
    if (!isEye(sensor)) return []
    const face: Command[] = [
      {
        kind: 'rect',
        x: -2.25,
        y: -1.35,
        width: 4.5,
        height: 2.5,
        round: 1.15,
        fill: sensor.kind === 'infrared' ? '#B8391C' : '#2F9C95',
        ...line,
      },
      dot(-1, -0.15, 0.62, 0.3),
      dot(1, -0.15, 0.62, 0.3),
    ]
    const lit = lights?.(`sensor ${port}`) ? [halo({ x: 0, y: 0 })] : []
    return [{ kind: 'group', ...eyeAt(sensor), turn: clockwise(sensor.angle), shapes: [...lit, ...face] }]
  })

function floorEye({ config, lights }: BoLook): readonly Command[] {
  const port = floorEyeOf(config)
  if (port === undefined) return []
  return [
    ...(lights?.(`sensor ${port}`) ? [halo({ x: 0, y: -5 })] : []),
    dot(0, -5, 0.95, 0.55),
    { kind: 'circle', x: 0, y: -5, r: 0.3, fill: '#4A3428' },
  ]
}

const display = (text: boolean): readonly Command[] => [
  { kind: 'rect', x: -3.6, y: -2.7, width: 7.2, height: 4.6, round: 1.1, fill: '#3A2A20', ...line },
  text
    ? { kind: 'path', d: 'M-2.3-1.4h4.6M-2.3-.4h3.4M-2.3 .6h4.2', stroke: '#FFF3D6', lineWidth: 0.55 }
    : {
        kind: 'path',
        d: 'M0 1.05c-1.9-1.2-1.9-2.6-.95-2.95.6-.2.85.35.95.6.1-.25.35-.8.95-.6C1.9-1.55 1.9-.15 0 1.05z',
        fill: '#FF7E62',
      },
]

function lamp({ led, lights }: BoLook): readonly Command[] {
  const fill = led ? lamps[led] : '#E9DDC8'
  const at = { x: 0, y: lampAt }
  return [
    ...(led ? [{ kind: 'circle' as const, ...at, r: 2.9, fill, opacity: 0.38 }] : []),
    ...(lights?.('lamp') ? [halo(at)] : []),
    { kind: 'circle', ...at, r: 1.3, fill, ...line, lineWidth: 0.6 },
  ]
}

const leaves: Command = {
  kind: 'group',
  ...{ x: 0, y: -7.15, scale: 0.1 },
  shapes: [
    { kind: 'path', d: 'M0 4C-16 6-22-4-20-12C-8-12 0-6 0 4Z', fill: '#7CC257', ...line, lineWidth: 4.6 },
    { kind: 'path', d: 'M0 4C2-8 10-14 20-10C20 2 10 8 0 4Z', fill: '#9AD56B', ...line, lineWidth: 4.6 },
  ],
}

/** Bo from above in cm about its middle, its front up. Eyes sit where the configuration has its distance sensors. */
export function drawBo(look: BoLook): readonly Command[] {
  const { config, text, colour = '#F28C45' } = look
  const half = config.wheelDiameter / 2
  const around = wheelsOf(config).map(
    ({ x }) => `M${x} ${0 - half}h${wheelWidth}v${2 * half}h-${wheelWidth}z`,
  )
  return [
    { kind: 'path', d: outline + around.join(''), fill: '#fff', stroke: '#fff', lineWidth: 2 },
    { kind: 'path', d: `M${0 - config.trackWidth / 2} 0h${config.trackWidth}`, ...line, lineWidth: 1.5 },
    ...wheels(look),
    ...shell(colour),
    ...eyes(look),
    ...floorEye(look),
    ...display(text),
    ...lamp(look),
    leaves,
  ]
}
