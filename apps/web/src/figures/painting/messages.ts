import type { SentFrame } from '#drawing/wire.ts'

/** A face of the page's letters. */
export interface Face {
  readonly family: string
  readonly source: string
  readonly weight: string
}

/** Messages to the worker that paints; `id`: of a canvas. */
export type Message =
  | { readonly kind: 'open'; readonly id: number; readonly canvas: OffscreenCanvas }
  | {
      readonly kind: 'frame'
      readonly id: number
      readonly frame: SentFrame
      /** Of the frames of this canvas. */
      readonly count: number
      /** The page wants to know when it is painted. */
      readonly isAwaited: boolean
    }
  | { readonly kind: 'close'; readonly id: number }
  | { readonly kind: 'letters'; readonly faces: readonly Face[] }

/** Messages to the page: so many frames of a canvas have come, and the last of them is painted. */
export interface Painted {
  readonly id: number
  readonly count: number
}
