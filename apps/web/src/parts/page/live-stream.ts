import type { Source } from './source.ts'

const closed = 2
/** In ms: a stream that the server refused is opened again after so long. */
const patience = 3000

/** A stream of the server that comes back: a browser opens one again that was cut, not one that was refused. */
export class LiveStream {
  readonly #open: () => Source
  readonly #hear: (source: Source) => void
  readonly #broke: () => void
  #source: Source | null = null
  #timer: ReturnType<typeof setTimeout> | undefined

  /**
   * @param hear listens to a source that was opened
   * @param broke it was cut or refused
   */
  constructor(open: () => Source, hear: (source: Source) => void, broke = () => {}) {
    this.#open = open
    this.#hear = hear
    this.#broke = broke
  }

  /** Is it wanted? That it stands too says `isOpen`. */
  get isWanted(): boolean {
    return this.#source !== null
  }
  get isOpen(): boolean {
    return this.#source?.readyState === 1
  }

  /** Opens it, anew where it is open: the old one may be dead without a word. */
  open(): void {
    this.close()
    const source = this.#open()
    this.#source = source
    this.#hear(source)
    source.addEventListener('error', () => this.#mend(source))
  }

  close(): void {
    clearTimeout(this.#timer)
    this.#source?.close()
    this.#source = null
  }

  #mend(source: Source): void {
    if (source !== this.#source) return
    this.#broke()
    if (source.readyState !== closed) return
    clearTimeout(this.#timer)
    this.#timer = setTimeout(() => this.open(), patience)
  }
}
