import type { View } from '@botgarten/lab'

/** A part of what is painted: a robot by its id, a part of it (`bo motor C`), a reading (`bo ray 2`), a thing by its id. */
export interface Place {
  readonly name: string
  /** Its middle in px of the window. */
  readonly x: number
  readonly y: number
  /** Does it light up with its block and its node? */
  readonly lit?: boolean
  /** What is written there. */
  readonly text?: string
}

/** What paints on a canvas and can say what it has painted. */
export interface Painter {
  places(): readonly Place[]
  /** Name of what is painted at a point of the window. */
  partAt(x: number, y: number): string | null
}

/**
 * What tests, measurements and curious people may ask of the page (`botgarten.view()`): what is on a canvas cannot be
 * found by looking for elements. It reads and changes nothing.
 */
interface Door extends Painter {
  /** The lab as it is shown, null where none is open. */
  view(): View | null
}

declare global {
  var botgarten: Door | undefined
}

const painters = new Set<Painter>()
let shown: (() => View) | null = null

const door: Door = Object.freeze({
  view: () => (shown ? structuredClone(shown()) : null),
  places: () => [...painters].flatMap((painter) => painter.places()),
  partAt(x: number, y: number) {
    for (const painter of painters) {
      const part = painter.partAt(x, y)
      if (part !== null) return part
    }
    return null
  },
})

/** Lets a painter answer for what it has painted. Returns how to end that. */
export function showParts(painter: Painter): () => void {
  painters.add(painter)
  return () => void painters.delete(painter)
}

/** Lets the page be asked about a lab. Returns how to end that. */
export function openDoor(view: () => View): () => void {
  shown = view
  globalThis.botgarten = door
  return () => void (shown = shown === view ? null : shown)
}
