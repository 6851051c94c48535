import { untrack } from 'svelte'
import { devicePixelRatio } from 'svelte/reactivity/window'
import type { World } from '@botgarten/simulation'
import { paint, type Picture } from '#drawing/canvas.ts'
import type { Command } from '#drawing/commands.ts'
import { pictureOf } from '#drawing/picture.ts'
import { drawFloor, drawGround, drawStations } from '#drawing/floor.ts'
import type { Point } from '#drawing/points.ts'
import type { Layer } from '#drawing/surface.ts'
import { letters } from '../letters.svelte.ts'
import type { Viewport } from './viewport.svelte.ts'

/** In px: what is kept goes on so far beyond the pane, and is painted again so seldom. */
const step = 256

/** The floor, as a picture that is painted once for the part that is looked at. */
export class FloorPicture {
  readonly #world: () => World
  readonly #url: () => string | null
  readonly #stations: () => readonly Point[]
  readonly #viewport: Viewport
  /** What lies on the ground, and from where it came; no image where none could be loaded. */
  #loaded = $state.raw<{ readonly url: string; readonly image: ImageBitmap | null } | null>(null)
  #asked: string | null = null

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
    if (this.#asked === url) return
    this.#asked = url
    if (url === null) return
    const image = new Image()
    image.onload = () => void this.#flatten(image, url)
    image.onerror = () => this.#take(null, url)
    image.src = url
  }

  /** A drawing is made pixels once, not whenever the floor is painted again. */
  async #flatten(image: HTMLImageElement, url: string): Promise<void> {
    this.#take(await createImageBitmap(image).catch(() => null), url)
  }

  #take(image: ImageBitmap | null, url: string): void {
    if (this.#asked === url) this.#loaded = { url, image }
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
  readonly layer: Layer = $derived.by(() => {
    const [world, url, { scale }] = [this.#world(), this.#url(), this.#viewport]
    const ground = drawGround(world)
    const over = [
      ...drawFloor(world, scale, url !== null),
      ...drawStations(this.#stations(), world.size.height, scale),
    ]
    // Until its picture is loaded: a bitmap for so few frames would cost more than to paint these shapes.
    if (url !== null && this.#loaded?.url !== url)
      return { kind: 'group', scale, shapes: [...ground, ...over] }
    return this.#pictureOf(ground, url === null ? null : this.#loaded!.image, over)
  })

  #pictureOf(ground: readonly Command[], image: ImageBitmap | null, over: readonly Command[]): Picture {
    const { place } = this
    const { scale } = this.#viewport
    const { width: acrossInCm, height: downInCm } = this.#world().size
    const ratio = devicePixelRatio.current ?? 1
    // Only what is written is painted again when letters come.
    const families = this.#stations().length > 0 ? letters.families : untrack(() => letters.families)
    const [width, height] = [place.width, place.height].map((length) => Math.round(length * ratio))
    const source = pictureOf(width!, height!, (context) => {
      context.scale(ratio, ratio)
      context.translate(-place.x, -place.y)
      context.scale(scale, scale)
      paint(context, ground, families)
      if (image) context.drawImage(image, 0, 0, acrossInCm, downInCm)
      paint(context, over, families)
    })
    return { source, ...place }
  }
}
