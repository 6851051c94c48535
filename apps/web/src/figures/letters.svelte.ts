import type { Families } from '#drawing/shapes.ts'
import type { Font } from '#drawing/commands.ts'
import { comfort } from '#storage/comfort.svelte.ts'

const names = ['title', 'read'] as const

/** The letters that canvases write with: those of the page's style. What reads them is told when others come. */
class Letters {
  /** How often letters have arrived. */
  #arrived = $state(0)
  #canvas: CanvasRenderingContext2D | null = null

  constructor() {
    globalThis.document?.fonts?.addEventListener('loadingdone', () => (this.#arrived += 1))
  }

  readonly families: Families = $derived.by(() => {
    void [comfort.has('letters'), this.#arrived]
    const style = getComputedStyle(document.documentElement)
    const [title, read] = names.map((name) => style.getPropertyValue(`--${name}`)) as [string, string]
    return { title, read }
  })

  /** Width of bold letters in px. */
  widthOf(text: string, size: number, font: Font): number {
    this.#canvas ??= document.createElement('canvas').getContext('2d')!
    // A canvas goes on with what it has found once under a name: the name is another one when letters come.
    this.#canvas.font = `700 ${size}px ${this.families[font]}, "arrival ${this.#arrived}"`
    return this.#canvas.measureText(text).width
  }
}

export const letters = new Letters()
