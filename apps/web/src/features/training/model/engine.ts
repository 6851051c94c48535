import { realTime } from './around.ts'
import { Host } from './host.ts'
import type { Ask, Order, Report } from './messages.ts'

/** Practises in a worker; where there is none, on the page in slices of 8 ms. */
export class Engine {
  readonly #listen: (report: Report) => void
  #worker: Worker | null = null
  #host: Host | null = null
  /** What a new one has to be told where the worker dies. */
  #begun: readonly Order[] = []
  #asked: Ask | null = null

  constructor(listen: (report: Report) => void) {
    this.#listen = listen
  }

  /** Has its worker ready before the first order. */
  warm(): void {
    if (this.#host === null && this.#worker === null) this.#start()
  }

  send(order: Order): void {
    if (order.kind === 'ask') this.#asked = order
    else if (order.kind === 'begin') this.#begun = [order]
    else if (order.kind !== 'heard' && this.#begun[0]) this.#begun = [this.#begun[0], order]
    this.warm()
    if (this.#host) this.#host.take(order)
    else this.#worker?.postMessage(order)
  }

  #start(): void {
    try {
      const worker = new Worker(new URL('./worker.ts', import.meta.url), { type: 'module' })
      worker.onerror = worker.onmessageerror = () => this.#fall()
      worker.onmessage = ({ data }: MessageEvent<Report>) => this.#listen(data)
      this.#worker = worker
    } catch {
      this.#host = this.#here()
    }
  }

  #here = () => new Host({ ...realTime(), post: this.#listen, slice: 8 })

  /** The worker is no use here: from its beginning again, which gives the same. */
  #fall(): void {
    this.#worker?.terminate()
    this.#worker = null
    this.#host = this.#here()
    for (const order of this.#begun) this.#host.take(order)
    if (this.#asked) this.#host.take(this.#asked)
  }

  close(): void {
    this.#worker?.terminate()
    this.#worker = null
    this.#host = null
  }
}
