import { isPale } from './colours.ts'
import type { Command, Group, Stripes } from './commands.ts'
import { labelOffsets, type Side } from './labels.ts'
import { ringFill } from './network.ts'
import { between, type Point, type Size } from './points.ts'
import { linkWidth, type Track } from './track.ts'

// A network, in px of its stage: x to the right, y down from its upper left corner.

/** A weighted link and the knob on it. */
export interface LinkLook {
  readonly track: Track
  /** Middle of its knob. */
  readonly at: Point
  readonly weight: number
  /** Its knob sets nothing that runs now. */
  readonly idle: boolean
  /** The last one that was touched. */
  readonly marked: boolean
  /** Radius within which the knob answers to a pointer. */
  readonly grip: number
  /** Where its weight is written; `width` of the letters; null: it is not. */
  readonly label: { readonly text: string; readonly width: number; readonly side: Side } | null
}

/** A neuron: a ring that its value fills, and the number in it. */
export interface NodeLook {
  readonly at: Point
  readonly colour: string
  /** null: nothing has run yet. */
  readonly value: number | null
  /** Its sensor is not there. */
  readonly missing: boolean
  /** Nothing comes here. */
  readonly pale: boolean
  /** Lights up with its block and the part of Bo that it stands for. */
  readonly lit: boolean
  /** Its sum is shown. */
  readonly chosen: boolean
}

/** A signal on a link: so many pulses at a time, one of them `share` (0 to 1) of the way. */
export interface Signal {
  readonly track: Track
  readonly count: number
  readonly share: number
}

/** How the device wants to see it. */
export interface Theme {
  /** Colour of what is chosen where a theme forces its own. */
  readonly forced: string | null
  /** For the wall. */
  readonly strong: boolean
}

const line = '#4A3428'
const ink = '#3A2A20'
const edgeOf = ({ strong }: Theme) => (strong ? '#6B5237' : '#8C7152')
const tomato = '#D8322A'
const sun = '#FFC83D'
/** Of what is not in the hand, and of a network that does not run. */
export const faded = 0.45

/** All links; the same object is painted as a picture. */
export const drawLinks = (links: readonly LinkLook[], stage: Size & Point, theme: Theme): Group => ({
  kind: 'group',
  still: stage,
  shapes: links.flatMap((link) => drawLink(link, theme)),
})

/** All knobs, those with a written weight over the others; the same object is painted as a picture. */
export const drawKnobs = (links: readonly LinkLook[], stage: Size & Point, theme: Theme): Group => ({
  kind: 'group',
  still: stage,
  shapes: [...links]
    .sort((a, b) => Number(a.weight !== 0) - Number(b.weight !== 0))
    .map((link) => drawKnob(link, false, theme)),
})

const blue: Stripes = { on: '#DCE4EA', colour: '#6F8596', every: 7, width: 4 }

function drawLink({ track: { from, to }, weight }: LinkLook, theme: Theme): readonly Command[] {
  const points = [from, to]
  if (weight === 0) return [{ kind: 'line', points, stroke: edgeOf(theme), lineWidth: 3, dash: [2, 8] }]
  const width = linkWidth(weight)
  const stripes = weight < 0 ? { stripes: blue } : {}
  return [
    { kind: 'line', points, stroke: line, lineWidth: width + 4, flat: true },
    { kind: 'line', points, stroke: '#F1C27D', lineWidth: width, flat: true, ...stripes },
  ]
}

const pulse = {
  kind: 'group',
  still: { x: -6, y: -6, width: 12, height: 12 },
  turns: true,
  shapes: [{ kind: 'circle', x: 0, y: 0, r: 4.7, fill: sun, stroke: line, lineWidth: 1.2 }],
} as const satisfies Group

/** Where the pulses of a signal are. */
export const pulsesOf = ({ track, count, share }: Signal): readonly Point[] =>
  Array.from({ length: count }, (_, k) => between(track.from, track.to, (k / count + share) % 1))

/** Pulses on their way along a link. */
export const drawSignal = (signal: Signal): Group => ({
  kind: 'group',
  shapes: pulsesOf(signal).map((at) => ({ ...pulse, ...at })),
})

/** A knob where its weight is, with the number. */
function drawKnob({ at, weight, idle, marked, grip, label }: LinkLook, held: boolean, theme: Theme): Group {
  const radius = weight === 0 ? 11 : 14
  const disc = (r: number, fill: string): Command => ({ kind: 'circle', x: 0, y: 0, r, fill })
  const tick = (x: number): Command => ({ kind: 'rect', x, y: -4, width: 2, height: 8, fill: '#fff' })
  return {
    kind: 'group',
    ...at,
    shapes: [
      ...(held || marked ? [around(grip, held, theme)] : []),
      disc(radius + 2, idle ? edgeOf(theme) : line),
      disc(radius, '#fff'),
      disc(radius - 2.5, idle ? '#E9B7AE' : tomato),
      tick(-4),
      tick(2),
      ...(label ? written(label) : []),
    ],
  }
}

const around = (grip: number, held: boolean, { forced }: Theme): Command =>
  forced
    ? { kind: 'circle', x: 0, y: 0, r: grip - 2, stroke: forced, lineWidth: 4 }
    : { kind: 'circle', x: 0, y: 0, r: grip, fill: tomato, opacity: held ? 0.24 : 0.16 }

function written({ text, width, side }: NonNullable<LinkLook['label']>): readonly Command[] {
  const { x, y } = labelOffsets[side]
  const box = Math.max(44, Math.ceil(width) + 16)
  return [
    {
      kind: 'rect',
      x: x - box / 2 + 1,
      y: y - 12,
      width: box - 2,
      height: 24,
      round: 8,
      fill: '#fff',
      stroke: line,
      lineWidth: 2,
    },
    { kind: 'text', text, x, y: y + 6, size: 18, font: 'title', align: 'middle', fill: ink },
  ]
}

/** The link in the hand with its signals and its knob. */
export const drawHeld = (link: LinkLook, signals: readonly Signal[], theme: Theme): Group => ({
  kind: 'group',
  shapes: [...drawLink(link, theme), ...signals.map(drawSignal), drawKnob(link, true, theme)],
})

/** What is written in a ring: whole, with a minus as long as a plus. */
export const shownValue = ({ value, missing }: Pick<NodeLook, 'value' | 'missing'>): string =>
  missing ? '?' : value === null ? '–' : String(Math.round(value)).replace('-', '−')

/** Rings were drawn so large, and are scaled to the radius of a node. */
const full = 47.5

/** A neuron as a ring; `plain`: one that has its colour instead of a value. */
export function drawNode(node: NodeLook, radius: number, theme: Theme, plain = false): Group {
  const { at, chosen, lit, missing } = node
  const text = shownValue(node)
  // Long numbers stay inside the ring.
  const size = radius * (text.length > 4 ? 0.42 : text.length > 3 ? 0.52 : 0.66)
  const reach = radius + 8
  return {
    kind: 'group',
    ...at,
    still: { x: -reach, y: -reach, width: 2 * reach, height: 2 * reach },
    shapes: [
      ...(chosen ? [halo(radius, theme)] : []),
      ...(lit ? [{ kind: 'circle' as const, x: 0, y: 0, r: radius + 6, fill: sun }] : []),
      {
        kind: 'group',
        scale: radius / full,
        shapes: missing
          ? [
              {
                kind: 'circle',
                x: 0,
                y: 0,
                r: 46,
                fill: '#FFF6DD',
                stroke: '#B25A00',
                lineWidth: 3.5,
                dash: [9, 7],
                flat: true,
              },
            ]
          : ring(node, plain),
      },
      ...(plain
        ? []
        : [
            {
              kind: 'text' as const,
              text,
              x: 0,
              y: size * 0.32,
              size,
              font: 'title' as const,
              align: 'middle' as const,
              fill: missing ? '#8A4500' : ink,
            },
          ]),
    ],
  }
}

const halo = (radius: number, { forced }: Theme): Command =>
  forced
    ? { kind: 'circle', x: 0, y: 0, r: radius + 2.5, stroke: forced, lineWidth: 5 }
    : { kind: 'circle', x: 0, y: 0, r: radius + 1.5, stroke: '#C2335B', lineWidth: 3, opacity: 0.28 }

function ring({ colour, value, pale }: NodeLook, plain: boolean): readonly Command[] {
  return [
    { kind: 'circle', x: 0, y: 0, r: 46, fill: '#fff', stroke: pale ? '#B59C86' : line, lineWidth: 2.5 },
    ...(plain
      ? [{ kind: 'circle' as const, x: 0, y: 0, r: 40.5, fill: colour }]
      : [{ kind: 'circle' as const, ...groove, stroke: '#EBDCC3' }, ...filled(value ?? 0, colour)]),
    ...(isPale(colour) ? [{ kind: 'circle' as const, x: 0, y: 0, r: 37, stroke: line, lineWidth: 1.5 }] : []),
  ]
}

const groove = { x: 0, y: 0, r: 41, lineWidth: 7 }

/** From the top clockwise, below 0 the other way round and striped. */
function filled(value: number, stroke: string): readonly Command[] {
  const { share, backwards } = ringFill(value)
  const percent = Math.round(share * 100)
  if (percent === 0) return []
  const round = 2 * Math.PI * groove.r
  const stripes = backwards ? { stripes: { on: '#fff', colour: stroke, every: 6, width: 3.4 } } : {}
  return [
    {
      kind: 'group',
      turn: -90,
      scale: [1, backwards ? -1 : 1],
      shapes: [
        { kind: 'circle', ...groove, stroke, dash: [(percent / 100) * round, round], flat: true, ...stripes },
      ],
    },
  ]
}
