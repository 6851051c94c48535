import { devicePixelRatio } from 'svelte/reactivity/window'
import type { World } from '@botgarten/simulation'
import { paint, type Picture } from '#drawing/canvas.ts'
import { pictureOf } from '#drawing/picture.ts'
import { drawFloor, drawGround, drawStations } from '#drawing/floor.ts'
import type { Point } from '#drawing/points.ts'
import { letters } from '../letters.svelte.ts'
import type { Viewport } from './viewport.svelte.ts'

/** In px: what is kept goes on so far beyond the pane, and is painted again so seldom. */
const step = 256

/** The floor as a picture, painted once for the part that is looked at. */
export class FloorPicture {
  readonly #world: () => World
  readonly #url: () => string | null
  readonly #stations: () => readonly Point[]
  readonly #viewport: Viewport
  #image = $state.raw<ImageBitmap | null>(null)
  #loaded: string | null = null

  /** @param stations middles of stations, by number, in cm, y up: their numbers stand on the floor */
  constructor(
    world: () => World,
    url: () => string | null,
    stations: () => readonly Point[],
    viewport: Viewport,
  ) {
    this.#world = world
    this.#url = url
    this.#stations = stations
    this.#viewport = viewport
  }

  /** Loads the picture that lies on the ground; for an effect. */
  load(): void {
    const url = this.#url()
    if (this.#loaded === url) return
    this.#loaded = url
    this.#image = null
    if (url === null) return
    const image = new Image()
    image.onload = () => void this.#flatten(image, url)
    image.src = url
  }

  /** A drawing is made pixels once, not whenever the floor is painted again. */
  async #flatten(image: HTMLImageElement, url: string): Promise<void> {
    const pixels = await createImageBitmap(image)
    if (this.#loaded === url) this.#image = pixels
  }

  readonly #left = $derived.by(() => Math.floor(-this.#viewport.corner.x / step) * step)
  readonly #top = $derived.by(() => Math.floor(-this.#viewport.corner.y / step) * step)
  readonly #width = $derived.by(() => (Math.ceil(this.#viewport.pane.width / step) + 1) * step)
  readonly #height = $derived.by(() => (Math.ceil(this.#viewport.pane.height / step) + 1) * step)

  /** What is painted of the floor's box, in px of it. */
  readonly place = $derived.by(() => ({
    x: this.#left,
    y: this.#top,
    width: this.#width,
    height: this.#height,
  }))

  /** A new object whenever it has been painted again; in px of the floor's box. */
  readonly picture: Picture = $derived.by(() => {
    const world = this.#world()
    const { scale } = this.#viewport
    const ratio = devicePixelRatio.current ?? 1
    const { place } = this
    const { families } = letters
    const [width, height] = [place.width, place.height].map((length) => Math.round(length * ratio))
    const source = pictureOf(width!, height!, (context) => {
      context.scale(ratio, ratio)
      context.translate(-place.x, -place.y)
      context.scale(scale, scale)
      paint(context, drawGround(world), families)
      if (this.#image) context.drawImage(this.#image, 0, 0, world.size.width, world.size.height)
      paint(context, drawFloor(world, scale, this.#url() !== null), families)
      paint(context, drawStations(this.#stations(), world.size.height, scale), families)
    })
    return { source, ...place }
  })
}
