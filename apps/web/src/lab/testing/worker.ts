import { AsyncLocalStorage } from 'node:async_hooks'
import { vi } from 'vitest'

interface Port {
  onmessage: ((event: { readonly data: unknown }) => void) | null
  readonly post: (data: unknown) => void
}

const port = new AsyncLocalStorage<Port>()

/** A worker that loads its module where the test runs. Messages are cloned, come in order, and later. */
class WorkerHere {
  static load: () => Promise<unknown>
  /** One at a time: the modules are forgotten before each. */
  static loading: Promise<unknown> = Promise.resolve()
  static all: WorkerHere[] = []

  onmessage: ((event: { readonly data: unknown }) => void) | null = null
  onerror: ((event: { readonly message: string }) => void) | null = null
  isOver = false
  #queue: Promise<unknown>
  readonly #port: Port = {
    onmessage: null,
    post: (data) => {
      const copy: unknown = structuredClone(data)
      queueMicrotask(() => this.isOver || this.onmessage?.({ data: copy }))
    },
  }

  constructor() {
    WorkerHere.all.push(this)
    WorkerHere.loading = WorkerHere.loading.then(() => port.run(this.#port, () => WorkerHere.load()))
    this.#queue = WorkerHere.loading
  }

  postMessage(data: unknown): void {
    const copy: unknown = structuredClone(data)
    this.#queue = this.#queue
      .then(() =>
        this.isOver ? undefined : port.run(this.#port, () => this.#port.onmessage?.({ data: copy })),
      )
      .catch((cause: unknown) => {
        this.isOver ||= (this.onerror?.({ message: String(cause) }), true)
      })
  }

  terminate(): void {
    this.isOver = true
  }
}

/**
 * Workers run where the test runs, until `vi.unstubAllGlobals()`.
 * @param load imports the worker's module; each worker gets a module of its own
 * @returns the workers that were made
 */
export function workersHere(load: () => Promise<unknown>): readonly { readonly isOver: boolean }[] {
  WorkerHere.all = []
  WorkerHere.load = () => {
    vi.resetModules()
    return load()
  }
  vi.stubGlobal('Worker', WorkerHere)
  vi.stubGlobal('self', {
    set onmessage(hear: Port['onmessage']) {
      port.getStore()!.onmessage = hear
    },
    postMessage: (data: unknown) => port.getStore()!.post(data),
  })
  return WorkerHere.all
}
