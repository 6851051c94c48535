/** How many events may wait for a slow reader. */
const most = 64
const encoder = new TextEncoder()

/** Server-sent events to one page. */
export class EventStream {
  readonly response: Response
  private controller!: ReadableStreamDefaultController<Uint8Array>
  private open = true
  private readonly closed: () => void

  /** @param closed called once, when either side has ended it */
  constructor(closed: () => void) {
    this.closed = closed
    const body = new ReadableStream<Uint8Array>(
      {
        start: (controller) => void (this.controller = controller),
        cancel: () => this.end(),
      },
      new CountQueuingStrategy({ highWaterMark: most }),
    )
    // A proxy is not to collect them.
    const headers = {
      'content-type': 'text/event-stream',
      'cache-control': 'no-store',
      'x-accel-buffering': 'no',
    }
    this.response = new Response(body, { headers })
  }

  private end() {
    if (!this.open) return
    this.open = false
    this.closed()
  }

  private write(text: string) {
    if (!this.open) return
    if ((this.controller.desiredSize ?? 0) <= 0) return this.close()
    this.controller.enqueue(encoder.encode(text))
  }

  send(event: string, data: unknown): void {
    this.write(`event: ${event}\ndata: ${JSON.stringify(data)}\n\n`)
  }

  /** Keeps proxies from thinking that nobody is there. */
  beat(): void {
    this.write(':\n\n')
  }

  close(): void {
    if (!this.open) return
    this.end()
    this.controller.close()
  }
}
