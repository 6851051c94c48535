/** One event of a stream. */
export interface Heard {
  readonly event: string
  readonly data: unknown
}

const heardIn = (block: string): Heard | null => {
  const [, event, data] = /^event: (\w+)\ndata: (.*)$/.exec(block) ?? []
  return event === undefined ? null : { event, data: JSON.parse(data!) as unknown }
}

/** Server-sent events of an answer to a request that was no GET, which the browser's EventSource cannot send. */
export async function* eventsIn(
  body: ReadableStream<Uint8Array>,
  signal: AbortSignal,
): AsyncGenerator<Heard> {
  const reader = body.getReader()
  signal.addEventListener('abort', () => void reader.cancel().catch(() => {}), { once: true })
  const decoder = new TextDecoder()
  let text = ''
  for (;;) {
    const { done, value } = await reader.read()
    if (done) return
    const blocks = (text + decoder.decode(value, { stream: true })).split('\n\n')
    text = blocks.pop()!
    for (const block of blocks) {
      const heard = heardIn(block)
      if (heard) yield heard
    }
  }
}
