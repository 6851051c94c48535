import { devicePixelRatio } from 'svelte/reactivity/window'
import { paint, type Picture } from '#drawing/canvas.ts'
import type { Command } from '#drawing/commands.ts'
import { pictureOf } from '#drawing/picture.ts'
import type { Point, Size } from '#drawing/points.ts'
import { letters } from '../letters.svelte.ts'

/** What is in a picture already. */
interface Painted {
  readonly dots: readonly Command[]
  readonly place: Size & Point
  readonly ratio: number
  readonly picture: Picture
}

/** Trails as a picture: after ten minutes they have thousands of dots, and only the new ones are painted. */
export class TrailPicture {
  readonly #dots: () => readonly Command[]
  readonly #place: () => Size & Point
  #painted: Painted | null = null

  /** @param dots in px of the floor's box, as is the `place` that is looked at; another object when it changes */
  constructor(dots: () => readonly Command[], place: () => Size & Point) {
    this.#dots = dots
    this.#place = place
  }

  /** A new object whenever dots were added; null: there is no trail. */
  readonly picture: Picture | null = $derived.by(() => {
    const [dots, place, ratio] = [this.#dots(), this.#place(), devicePixelRatio.current ?? 1]
    const before = this.#goesOn(dots, place, ratio) ? this.#painted : null
    const picture = dots.length > 0 ? painted(dots, place, ratio, before) : null
    this.#painted = picture && { dots, place, ratio, picture }
    return picture
  })

  #goesOn(dots: readonly Command[], place: Size & Point, ratio: number): boolean {
    const before = this.#painted
    if (before?.place !== place || before.ratio !== ratio) return false
    return before.dots.every((one) => dots.includes(one))
  }
}

function painted(
  dots: readonly Command[],
  place: Size & Point,
  ratio: number,
  before: Painted | null,
): Picture {
  const [width, height] = [place.width, place.height].map((length) => Math.round(length * ratio))
  const source = pictureOf(width!, height!, (context) => {
    if (before) context.drawImage(before.picture.source, 0, 0)
    context.setTransform(ratio, 0, 0, ratio, -place.x * ratio, -place.y * ratio)
    const fresh = dots.filter((one) => !before?.dots.includes(one))
    paint(context, fresh, letters.families)
  })
  return { source, ...place }
}
