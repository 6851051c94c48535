import type { Point, Size } from './points.ts'
import { clamp } from './points.ts'

/** `below`: on lines under the node · `beside`: on the node's outer side, where rows are low. */
type LabelForm = 'below' | 'beside'

/** Where the nodes of a network stand, in px; from the inputs to the outputs. */
export interface NetworkLayout {
  readonly radius: number
  readonly columns: readonly (readonly Point[])[]
  /** Size of the stage; higher than the room there is when nodes would get smaller than a finger. */
  readonly stage: Size
  readonly labels: LabelForm
  readonly labelWidth: number
  /** Room for what is said second (the place of a sensor or wheel). */
  readonly places: boolean
}

const smallestRadius = 22
const largestRadius = 60
const gapBetweenRows = 12
// The weight of a level link stands this high over the middle of its nodes.
const overMiddle = 52
const highestRow = 240
const wide = 500
// Links get no longer than this, however wide the room.
const longestLink = 760
const lineHeight = 18
// A name in a narrower column breaks into more lines than a row has room for.
const narrowestLabel = 100
// From here on a label may take three lines.
const roomyRow = 160

interface Labelling {
  readonly form: LabelForm
  readonly places: boolean
  readonly height: number
}

/** Node places for `inputs` sensors left and `outputs` actuators right in a room of `room` px. */
export function layoutNetwork(room: Size, inputs: number, outputs: number): NetworkLayout {
  const rows = Math.max(inputs, outputs, 1)
  const label = labelling(room, room.height / rows)
  const { radius, row, above } = rowsIn(room, rows, label)
  const height = Math.max(room.height, above + rows * row)
  const side = sideOf(room.width, radius, label.form)
  const column = (count: number, x: number) => {
    const share = (rows * row) / count
    const top = above + (height - above - rows * row) / 2
    const middle = (share - 2 * radius - label.height) / 2 + radius
    return Array.from({ length: count }, (_, i) => ({ x, y: top + i * share + middle }))
  }
  return {
    radius,
    stage: { width: room.width, height },
    labels: label.form,
    places: label.places,
    labelWidth: labelWidth(label, side, radius),
    columns: [column(inputs, side), column(outputs, room.width - side)],
  }
}

function labelling({ width }: Size, row: number): Labelling {
  if (width < wide) return { form: 'below', places: row >= 124, height: lineHeight * (row >= 124 ? 3 : 2) }
  // Under a node in a low row a label would lie on the links and their knobs.
  if (row < 124) return { form: 'beside', places: true, height: 0 }
  return { form: 'below', places: true, height: lineHeight * (row >= roomyRow ? 3 : 2) + 4 }
}

/** Height of a row, radius of a node, and the room over the first row that its weights need. */
function rowsIn(room: Size, rows: number, { height, form }: Labelling) {
  const content = height + gapBetweenRows
  const beside = room.height / rows < 100 ? 24 : 32
  const largest = form === 'beside' ? beside : clamp(room.width * 0.105, 42, largestRadius)
  const rowOf = (all: number) => clamp(all / rows, 2 * smallestRadius + content, highestRow)
  const middle = (rowOf(room.height) - height) / 2
  // What is left out above makes the rows lower, and with them their middle.
  const above = Math.max(0, (overMiddle - middle) / (1 - 1 / (2 * rows)))
  const row = rowOf(room.height - above)
  return { row, above, radius: clamp((row - content) / 2, smallestRadius, largest) }
}

function labelWidth({ form, height, places }: Labelling, side: number, radius: number): number {
  if (form === 'beside') return side - radius - 14
  const clear = height >= 3 * lineHeight ? 8 : places ? Infinity : 28
  return Math.min(2 * side - 4, Math.max(narrowestLabel, 2 * radius + clear))
}

function sideOf(width: number, radius: number, form: LabelForm): number {
  const share = form === 'beside' ? 106 + radius : clamp(width * 0.18, radius + 14, 140)
  return Math.max(share, (width - longestLink) / 2)
}

/** How much of a ring 0..1 a value fills, and which way round. */
export const ringFill = (value: number): { readonly share: number; readonly backwards: boolean } => ({
  share: Math.min(1, Math.abs(value) / 100),
  backwards: value < 0,
})
