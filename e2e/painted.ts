import type { Brain } from '@botgarten/learning/neural-network'
import { expect, type Locator, type Page } from '@playwright/test'
import type { Spot } from './hand.ts'

/** A part of what is painted on a canvas: `bo`, `bo motor C`, a thing by its id. */
export interface Place extends Spot {
  readonly name: string
  /** Does it light up with its block and its node? */
  readonly lit?: boolean
  /** What is written there. */
  readonly text?: string
}

interface Placed {
  readonly id: string
  readonly pose: { readonly x: number; readonly y: number; readonly heading: number }
}

declare global {
  /** What the page can be asked about what it paints; empty in builds that draw with elements. */
  var botgarten:
    | {
        view(): {
          readonly tick: number
          readonly robots: readonly Placed[]
          readonly obstacles: readonly Placed[]
          readonly brains: { readonly [network: string]: Brain }
          readonly networks: {
            readonly [network: string]: { readonly outputs: { readonly [neuron: string]: number } }
          }
        } | null
        places(): readonly Place[]
        partAt(x: number, y: number): string | null
      }
    | undefined
  var copyOf: (canvas: HTMLCanvasElement) => CanvasRenderingContext2D
}

/** What the canvases of a page show. */
export class Painted {
  readonly #page: Page

  constructor(page: Page) {
    this.#page = page
  }

  places(): Promise<readonly Place[]> {
    return this.#page.evaluate(() => globalThis.botgarten?.places() ?? [])
  }

  /** Where a part is on the screen, as soon as it is painted. */
  async place(name: string): Promise<Place> {
    await expect.poll(async () => (await this.places()).map((one) => one.name)).toContain(name)
    return (await this.places()).find((one) => one.name === name)!
  }

  partAt({ x, y }: Spot): Promise<string | null> {
    return this.#page.evaluate(([x, y]) => globalThis.botgarten!.partAt(x, y), [x, y] as const)
  }

  /** What is written where something stands that answers to a hand. */
  async textIn(thing: Locator): Promise<string | undefined> {
    const { x, y, width, height } = (await thing.boundingBox())!
    const middle = { x: x + width / 2, y: y + height / 2 }
    return (await this.places()).find(
      ({ text, ...at }) => text !== undefined && Math.hypot(at.x - middle.x, at.y - middle.y) < 2,
    )?.text
  }

  /** Names of what lights up. */
  async lit(): Promise<readonly string[]> {
    return (await this.places()).flatMap(({ name, lit }) => (lit ? [name] : []))
  }

  /** Where a robot stands on its floor, to a hundredth of a cm and of a degree. */
  stands(number = 1): Promise<string> {
    return this.#page.evaluate((index) => {
      const { x, y, heading } = globalThis.botgarten!.view()!.robots[index]!.pose
      // A heading of 359.999 degrees is one of 0.
      return [x, y, (Number(heading.toFixed(2)) + 360) % 360].map((part) => part.toFixed(2)).join()
    }, number - 1)
  }

  /** How far Bo's wheels are apart on the screen, in px. */
  async wheelsApart(): Promise<number> {
    const [left, right] = [await this.place('bo motor C'), await this.place('bo motor B')]
    return Math.hypot(right.x - left.x, right.y - left.y)
  }

  /** The colour of the floor beside Bo, as `colourAt` says it. */
  async floorColour(): Promise<string> {
    const { x, y } = await this.place('bo')
    return this.colourAt({ x, y: y + 60 })
  }

  /** The colour that the canvas has that is painted at a point of the screen, `r,g,b,a` with 0 to 255 each. */
  async colourAt(spot: Spot): Promise<string> {
    await this.#page.evaluate(copyOfCanvas)
    return this.#page.evaluate((at) => {
      const canvas = [...document.querySelectorAll('canvas')].findLast((one) => {
        const { left, right, top, bottom } = one.getBoundingClientRect()
        if (getComputedStyle(one).visibility === 'hidden') return false
        return at.x >= left && at.x < right && at.y >= top && at.y < bottom
      })
      if (!canvas) throw new Error(`Nothing is painted at ${at.x}, ${at.y}.`)
      const { left, top, width } = canvas.getBoundingClientRect()
      const copy = globalThis.copyOf(canvas)
      const ratio = copy.canvas.width / width
      const [x, y] = [(at.x - left) * ratio, (at.y - top) * ratio]
      return copy.getImageData(Math.round(x), Math.round(y), 1, 1).data.join()
    }, spot)
  }

  /** What is painted on a canvas, as the address of a PNG. */
  async drawing(canvas: Locator): Promise<string> {
    await this.#page.evaluate(copyOfCanvas)
    return canvas.evaluate((one) => globalThis.copyOf(one as HTMLCanvasElement).canvas.toDataURL())
  }
}

/** A canvas that a worker paints cannot be read: it is looked at through another one. */
async function copyOfCanvas() {
  globalThis.copyOf = (canvas) => {
    const { width, height } = canvas
    const context = Object.assign(document.createElement('canvas'), { width, height }).getContext('2d')!
    context.drawImage(canvas, 0, 0, width, height)
    return context
  }
  // What the page has asked for is painted by then.
  const frame = () => new Promise((done) => requestAnimationFrame(done))
  for (let passed = 0; passed < 3; passed += 1) await frame()
}
