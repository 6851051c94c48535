import { Surface, type Frame } from '#drawing/surface.ts'
import { Sender } from '#drawing/wire.ts'
import type { Face, Message, Painted } from './messages.ts'

/** What shows frames on a canvas. */
export interface Shower {
  /** @param painted is called as soon as it, or one after it, is on the canvas */
  show(frame: Frame, painted?: () => void): void
  close(): void
}

/** Who waits for a frame of a canvas. */
interface Waiting {
  readonly count: number
  readonly painted: () => void
}

/** Can a worker of this browser paint, with letters? */
const canPaint = () =>
  typeof OffscreenCanvas !== 'undefined' &&
  'transferControlToOffscreen' in HTMLCanvasElement.prototype &&
  typeof Worker !== 'undefined'

const isFace = (rule: CSSRule): rule is CSSFontFaceRule => rule instanceof CSSFontFaceRule

/**
 * The address from which the browser loaded this document. Inline styles name their files relative to it, and
 * `document.baseURI` changes with each page that a link inside the lab opens.
 */
const loadedFrom = () => performance.getEntriesByType('navigation')[0]?.name ?? document.baseURI

/** Faces in the page's styles, with complete addresses. */
function facesOf(sheet: CSSStyleSheet): readonly Face[] {
  const base = sheet.href ?? loadedFrom()
  return [...sheet.cssRules].filter(isFace).map(({ style }) => ({
    family: unquoted(style.getPropertyValue('font-family')),
    source: style
      .getPropertyValue('src')
      .replaceAll(/url\("?([^")]+)"?\)/g, (_, url: string) => `url("${new URL(url, base).href}")`),
    weight: style.getPropertyValue('font-weight') || 'normal',
  }))
}

const unquoted = (family: string) => family.replaceAll(/["']/g, '')

/** Faces that the page writes with. */
function loadedFaces(): readonly Face[] {
  const loaded = new Set(
    [...document.fonts].filter(({ status }) => status === 'loaded').map(({ family }) => unquoted(family)),
  )
  return [...document.styleSheets].flatMap(facesOf).filter(({ family }) => loaded.has(family))
}

/** Paints all canvases of the page: in a worker, where the browser has one that can; else where the page runs. */
class Painting {
  #worker: Worker | null = null
  #next = 0
  readonly #waiting = new Map<number, Waiting>()
  /** Letters that the worker knows. */
  #families: unknown = null
  /** The worker is no use here: canvases are new ones from then on. */
  failed = $state(false)

  get #usable(): Worker | null {
    if (this.failed || !canPaint()) return null
    this.#worker ??= this.#start()
    return this.#worker
  }

  #start(): Worker {
    const worker = new Worker(new URL('./worker.ts', import.meta.url), { type: 'module' })
    worker.onerror = worker.onmessageerror = () => {
      worker.terminate()
      this.#worker = null
      this.failed = true
    }
    worker.onmessage = ({ data: { id, count } }: MessageEvent<Painted>) => {
      const waiting = this.#waiting.get(id)
      if (!waiting || waiting.count > count) return
      this.#waiting.delete(id)
      waiting.painted()
    }
    return worker
  }

  /** @param canvas that nobody has painted on */
  on(canvas: HTMLCanvasElement): Shower {
    return this.#usable ? this.#beside(canvas) : here(canvas)
  }

  #beside(canvas: HTMLCanvasElement): Shower {
    const id = this.#next++
    const sender = new Sender()
    const offscreen = canvas.transferControlToOffscreen()
    this.#post({ kind: 'open', id, canvas: offscreen }, [offscreen])
    // Each canvas sends the faces again: the worker loads those that did not arrive.
    this.#families = null
    let count = 0
    return {
      show: (frame, painted) => {
        if (frame.families !== this.#families) this.#post({ kind: 'letters', faces: loadedFaces() })
        this.#families = frame.families
        const sent = sender.send(frame)
        if (!sent) return painted?.()
        count += 1
        if (painted) this.#waiting.set(id, { count, painted })
        this.#post({ kind: 'frame', id, frame: sent, count, isAwaited: this.#waiting.has(id) })
      },
      close: () => {
        this.#waiting.delete(id)
        this.#post({ kind: 'close', id })
      },
    }
  }

  #post(message: Message, transfer: readonly Transferable[] = []): void {
    this.#worker?.postMessage(message, [...transfer])
  }
}

function here(canvas: HTMLCanvasElement): Shower {
  const surface = new Surface(canvas.getContext('2d')!, () =>
    document.createElement('canvas').getContext('2d')!,
  )
  return {
    show(frame, painted) {
      surface.show(frame)
      painted?.()
    },
    close: () => undefined,
  }
}

export const painting = new Painting()
