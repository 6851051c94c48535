import type { Server } from './world.ts'

/** Reads server-sent events of an answer as a browser's EventSource does, in this process. */
export class StreamSource {
  readyState = 0
  readonly #hear = new Map<string, (event: { readonly data: string }) => void>()
  #reader: ReadableStreamDefaultReader<Uint8Array> | undefined

  constructor(answer: Promise<Response>) {
    void this.#read(answer)
  }

  addEventListener(name: string, hear: (event: { readonly data: string }) => void): void {
    this.#hear.set(name, hear)
  }

  close(): void {
    this.readyState = 2
    void this.#reader?.cancel()
  }

  /** The cable is pulled: a browser reports an error and goes on trying. */
  cut(): void {
    this.readyState = 0
    void this.#reader?.cancel()
    this.#fail()
  }

  #fail() {
    this.#hear.get('error')?.({ data: '' })
  }

  async #read(coming: Promise<Response>) {
    const answer = await coming
    if (!answer.ok || !answer.body) {
      this.readyState = 2
      return this.#fail()
    }
    this.readyState = 1
    this.#reader = answer.body.getReader()
    const decoder = new TextDecoder()
    let text = ''
    for (;;) {
      const { done, value } = await this.#reader.read()
      if (done) return
      text += decoder.decode(value, { stream: true })
      const events = text.split('\n\n')
      text = events.pop()!
      for (const one of events) this.#emit(one)
    }
  }

  #emit(event: string) {
    const [, name, data] = /^event: (\w+)\ndata: (.*)$/s.exec(event) ?? []
    if (name) this.#hear.get(name)?.({ data: data! })
  }
}

/** Lets everything that is on its way arrive. */
export async function settle({ ports }: Server): Promise<void> {
  await ports.live.flush()
  for (let turn = 0; turn < 20; turn++) await new Promise((resolve) => setImmediate(resolve))
}
