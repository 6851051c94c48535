import type { Phase } from '#drawing/nudge.ts'
import { distance, type Point } from '#drawing/points.ts'
import { alongMovement, knobPlace, knobPlaces, linksAt, weightAt, type Track } from '#drawing/track.ts'

interface Hold {
  readonly pointer: number
  readonly down: Point
  /** Links the finger may mean; one is left as soon as it has moved. */
  readonly candidates: readonly number[]
  /** From the finger to the knob, so that a touch alone changes nothing. */
  readonly offset: Point
  readonly moving: boolean
}

// A finger has to move this far (px) to say which of two knobs it means, or that it means to drag.
const slop = 4

/** A child's finger on the links: which knob it holds, and which weight it sets. Points in px of the stage. */
export class Grab {
  #hold = $state.raw<Hold | null>(null)
  #set: (link: number, weight: number, phase: Phase) => void
  #weight = 0

  constructor(set: (link: number, weight: number, phase: Phase) => void) {
    this.#set = set
  }

  /** The link whose knob is in the hand, or null. */
  get active(): number | null {
    return this.#hold && this.#hold.candidates.length === 1 ? this.#hold.candidates[0]! : null
  }

  /** Is there something under the finger? Then it is held from now on. */
  down(pointer: number, at: Point, tracks: readonly Track[], weights: readonly number[]): boolean {
    if (this.#hold) return false
    const candidates = linksAt(tracks, weights, at)
    const first = candidates[0]
    if (first === undefined) return false
    const knob = knobPlace(tracks[first]!, weights[first] ?? 0)
    const onKnob = distance(knobPlaces(tracks, weights)[first]!, at) <= 24
    const offset = onKnob ? { x: knob.x - at.x, y: knob.y - at.y } : { x: 0, y: 0 }
    this.#hold = { pointer, down: at, candidates, offset, moving: false }
    this.#weight = weights[first] ?? 0
    if (!onKnob) this.#begin(first, weights, at, tracks)
    return true
  }

  move(pointer: number, at: Point, tracks: readonly Track[], weights: readonly number[]): void {
    const hold = this.#hold
    if (hold?.pointer !== pointer) return
    const by = { x: at.x - hold.down.x, y: at.y - hold.down.y }
    if (!hold.moving) {
      if (Math.hypot(by.x, by.y) < slop) return
      this.#begin(alongMovement(tracks, hold.candidates, by), weights, at, tracks)
    } else this.#slide(at, tracks)
  }

  up(pointer: number): void {
    const hold = this.#hold
    if (hold?.pointer !== pointer) return
    this.#hold = null
    if (hold.moving) this.#set(hold.candidates[0]!, this.#weight, 'end')
  }

  #begin(link: number, weights: readonly number[], at: Point, tracks: readonly Track[]): void {
    this.#hold = { ...this.#hold!, candidates: [link], moving: true }
    this.#weight = weights[link] ?? 0
    this.#set(link, this.#weight, 'start')
    this.#slide(at, tracks)
  }

  #slide(at: Point, tracks: readonly Track[]): void {
    const { candidates, offset } = this.#hold!
    const link = candidates[0]!
    const weight = weightAt(tracks[link]!, { x: at.x + offset.x, y: at.y + offset.y })
    if (weight === this.#weight) return
    this.#weight = weight
    this.#set(link, weight, 'move')
  }
}
