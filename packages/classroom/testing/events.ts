export interface Heard {
  readonly event: string
  readonly data: unknown
}

/** Reads the events of an answer, one at a time. */
export class Events {
  private readonly reader: ReadableStreamDefaultReader<Uint8Array>
  private readonly decoder = new TextDecoder()
  private text = ''

  constructor(answer: Response) {
    this.reader = answer.body!.getReader()
  }

  /** The next event; null where the stream has ended. Beats are no events. */
  async next(): Promise<Heard | null> {
    for (;;) {
      const end = this.text.indexOf('\n\n')
      if (end >= 0) {
        const block = this.text.slice(0, end)
        this.text = this.text.slice(end + 2)
        const [, event, data] = /^event: (\w+)\ndata: (.*)$/.exec(block) ?? []
        if (event) return { event, data: JSON.parse(data!) as unknown }
        continue
      }
      const { done, value } = await this.reader.read()
      if (done) return null
      this.text += this.decoder.decode(value, { stream: true })
    }
  }

  /** Reads on until an event fits. */
  async until(fits: (heard: Heard) => boolean): Promise<Heard> {
    for (;;) {
      const heard = await this.next()
      if (heard === null) throw new Error('The stream has ended.')
      if (fits(heard)) return heard
    }
  }

  stop = () => this.reader.cancel()
}
