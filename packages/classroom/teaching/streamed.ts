/** A JSON file that is written while it is sent: a class or a pupil as a whole might not fit into memory. */
export function streamed(pieces: AsyncGenerator<string>, name: string): Response {
  const encoder = new TextEncoder()
  const body = new ReadableStream<Uint8Array>({
    async pull(controller) {
      const next = await pieces.next()
      if (next.done) controller.close()
      else controller.enqueue(encoder.encode(next.value))
    },
    async cancel() {
      await pieces.return(undefined)
    },
  })
  const headers = {
    'content-type': 'application/octet-stream',
    'content-disposition': `attachment; filename*=UTF-8''${encodeURIComponent(`botgarten-${name}.json`)}`,
  }
  return new Response(body, { headers })
}

/** A JSON array, an item at a time. */
export async function* arrayOf(items: AsyncIterable<unknown>): AsyncGenerator<string> {
  let mark = '['
  for await (const item of items) {
    yield mark + JSON.stringify(item)
    mark = ','
  }
  yield mark === '[' ? '[]' : ']'
}
