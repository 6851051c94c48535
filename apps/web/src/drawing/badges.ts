import type { Command } from './commands.ts'
import { clamp, type Point, type Size } from './points.ts'

type Picture = 'display' | 'sound' | 'light' | 'bumper' | 'turn' | 'ear' | 'compass' | 'speech'

/** What Bo senses or does, written beside it. */
export interface Badge {
  readonly id: string
  /** A part of what it senses with has a teal edge, one that it acts with an apricot one. */
  readonly side: 'sensor' | 'output'
  /** A spot in this colour, or a small picture. */
  readonly icon: { readonly colour: string } | Picture
  readonly label: string
  /** Rows, the first beside the label. */
  readonly value: readonly string[]
  /** Nothing shines, shows or sounds. */
  readonly idle: boolean
  /** The part of Bo that it is about. */
  readonly part: string
}

type WidthOf = (text: string, size: number, font: 'title' | 'read') => number

const letters = { label: 13.5, value: 15 }
const pad = 9
const iconRoom = 27
const rowHeight = 19
const gap = 6

export const labelWidth = ({ label }: Badge, widthOf: WidthOf): number =>
  widthOf(label, letters.label, 'read') + gap

/** How large a badge is, in px. */
export function sizeOf(badge: Badge, widthOf: WidthOf): Size {
  const values = badge.value.map((row) => widthOf(row, letters.value, 'read'))
  return {
    width: pad + iconRoom + labelWidth(badge, widthOf) + Math.max(0, ...values) + pad + 3,
    height: 34 + rowHeight * (badge.value.length - 1),
  }
}

type Box = Point & Size

const meet = (a: Box, b: Box) =>
  a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height

/** How near a circle comes to a box. */
const away = ({ x, y, width, height }: Box, from: Point) =>
  Math.hypot(from.x - clamp(from.x, x, x + width), from.y - clamp(from.y, y, y + height))

/** The lower, the sooner a place is taken. */
interface Ranked {
  readonly rank: number
}

const corners: readonly Point[] = [
  { x: 1, y: 1 },
  { x: -1, y: 1 },
  { x: -1, y: -1 },
  { x: 1, y: -1 },
]
/** How much of Bo's radius a badge stands off along each axis. */
const off = 0.85
const margin = 8

export interface Around {
  readonly bo: Point
  /** Degrees counter-clockwise from the right: Bo looks there, and its rays go there. */
  readonly heading: number
  readonly radius: number
  /** What is seen of the floor. */
  readonly area: Box
  /** Where nothing should be written. */
  readonly taken: readonly Box[]
}

/** Places round Bo, those behind it first, where badges stand one above the other too. */
function placesFor(size: Size, { bo, heading, radius, area }: Around): readonly (Box & Ranked)[] {
  const turn = (heading * Math.PI) / 180
  const ahead = ({ x, y }: Point) => x * Math.cos(turn) - y * Math.sin(turn)
  return [0, 1, 2]
    .flatMap((row) => corners.map((corner) => ({ ...corner, row, rank: ahead(corner) + 1.2 * row })))
    .map(({ x, y, row, rank }) => {
      const across = bo.x + x * (off * radius + size.width / 2) - size.width / 2
      const down = bo.y + y * (off * radius + size.height / 2 + row * (size.height + gap)) - size.height / 2
      return {
        ...size,
        rank,
        x: clamp(across, area.x + margin, area.x + area.width - size.width - margin),
        y: clamp(down, area.y + margin, area.y + area.height - size.height - margin),
      }
    })
}

/** The side on which each badge stands, by its id. */
export type BadgeSides = Map<string, number>
export const badgeSides = (): BadgeSides => new Map()

/**
 * Where badges stand, clear of Bo, of each other and of what is taken. One that stands well stays on its side: they do not
 * jump about while Bo turns. @param last the side of each, by its id; it is updated
 */
export function placeBadges(
  badges: readonly (Size & { readonly id: string })[],
  around: Around,
  last: BadgeSides,
): readonly Box[] {
  const placed: Box[] = []
  for (const { id, width, height } of badges) {
    const places = placesFor({ width, height }, around)
    const isFree = (box: Box | undefined) =>
      box !== undefined &&
      away(box, around.bo) >= around.radius * 0.95 &&
      ![...around.taken, ...placed].some((other) => meet(box, other))
    const ranked = places
      .map((place, index) => ({ place, index }))
      .sort((a, b) => a.place.rank - b.place.rank)
    const before = last.get(id)
    const kept = before !== undefined && isFree(places[before]) ? before : undefined
    const index = kept ?? (ranked.find(({ place }) => isFree(place)) ?? ranked[0]!).index
    last.set(id, index)
    const { x, y } = places[index]!
    placed.push({ x, y, width, height })
  }
  return placed
}

const ink = '#3A2A20'
const ink2 = '#6B5545'
const edges = { sensor: '#2F9C95', output: '#F28C45', idle: '#DCC7A5' }

/** In a square of 20. */
const white = (d: string, lineWidth = 1.6): Command => ({ kind: 'path', d, stroke: '#fff', lineWidth })
const pictures: { readonly [icon in Picture]: readonly Command[] } = {
  display: [
    { kind: 'rect', x: 4, y: 5.5, width: 12, height: 9, round: 1.5, stroke: '#fff', lineWidth: 1.8 },
    { kind: 'path', d: 'M7 9h6M7 11.5h4', stroke: '#fff', lineWidth: 1.5 },
  ],
  sound: [
    { kind: 'path', d: 'M4.5 8v4h2.5l3.5 3V5L7 8z', fill: '#fff', stroke: '#fff', lineWidth: 1 },
    {
      kind: 'path',
      d: 'M12.8 7.5c1.3 1.4 1.3 3.6 0 5M15 5.5c2.4 2.6 2.4 6.4 0 9',
      stroke: '#fff',
      lineWidth: 1.6,
    },
  ],
  light: [
    { kind: 'circle', x: 10, y: 10, r: 3, fill: '#fff' },
    {
      kind: 'path',
      d: 'M10 3.5v1.5M10 15v1.5M3.5 10h1.5M15 10h1.5M5.5 5.5l1 1M13.5 13.5l1 1M14.5 5.5l-1 1M6.5 13.5l-1 1',
      stroke: '#fff',
      lineWidth: 1.6,
    },
  ],
  bumper: [white('M4 9c3.5-4 8.5-4 12 0', 2.2), white('M10 9.5v5M7.5 12.5l2.5-3l2.5 3')],
  turn: [white('M15 10a5 5 0 1 1-2-4'), white('M13.5 2.8l-.2 3.6l-3.5-.6')],
  ear: [
    white('M10 4v7M10 4a1.5 1.5 0 0 0-1.5 1.5v4a1.5 1.5 0 0 0 3 0v-4A1.5 1.5 0 0 0 10 4', 2),
    white('M6 9.5a4 4 0 0 0 8 0M10 13.5v2.5'),
  ],
  compass: [white('M10 4l2.5 6l-2.5 6l-2.5-6z'), { kind: 'circle', x: 10, y: 10, r: 1.2, fill: '#fff' }],
  speech: [white('M4 5.5h12v7h-6l-3 3v-3h-3z'), white('M7 9h6', 1.4)],
}

function iconOf({ icon, side, idle }: Badge, x: number, y: number): readonly Command[] {
  if (typeof icon === 'object')
    return [
      { kind: 'circle', x, y, r: 9.5, fill: icon.colour, stroke: idle ? ink2 : '#4A3428', lineWidth: 2 },
    ]
  const fill = idle ? ink2 : icon === 'display' ? ink : edges[side]
  return [
    { kind: 'rect', x: x - 10, y: y - 10, width: 20, height: 20, round: 5, fill },
    { kind: 'group', x: x - 10, y: y - 10, shapes: pictures[icon] },
  ]
}

/** The line from a badge to what it is about. */
export const drawLead = (badge: Badge, { x, y, width, height }: Box, to: Point): Command => ({
  kind: 'line',
  points: [{ x: x + width / 2, y: y + height / 2 }, to],
  stroke: badge.idle ? edges.idle : edges[badge.side],
  lineWidth: 2.5,
})

/** A badge with its upper left corner at `at`. */
export function drawBadge(badge: Badge, { x, y, width, height }: Box, labelRoom: number): readonly Command[] {
  const { side, idle, label, value } = badge
  const left = x + pad + iconRoom
  const line = y + 22
  const shared = { kind: 'text' as const, font: 'read' as const }
  return [
    { kind: 'rect', x, y: y + 2, width, height, round: 11, fill: '#6E5032', opacity: 0.14 },
    {
      ...{ kind: 'rect', x, y, width, height, round: 11, lineWidth: 2 },
      fill: idle ? '#FBF5EA' : '#FFFDF8',
      stroke: idle ? edges.idle : edges[side],
    },
    ...iconOf(badge, x + pad + 10, y + 17),
    { ...shared, x: left, y: line, text: label, size: letters.label, fill: ink2 },
    ...value.map((text, row) => ({
      ...shared,
      x: left + labelRoom,
      y: line + row * rowHeight,
      text,
      size: letters.value,
      fill: idle ? ink2 : ink,
    })),
  ]
}
