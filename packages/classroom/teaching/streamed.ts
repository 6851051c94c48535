import { setTimeout as wait } from 'node:timers/promises'
import type { Slots } from '../slots.ts'

/** Letters that are sent at once: others have their turn between two of them, and a project may have 5 MB. */
const most = 250_000
/** Letters a ms. */
const speed = 2000

/** Short pieces of a long one. No letter of two code units is cut. */
function* cut(text: string): Generator<string> {
  for (let at = 0; at < text.length;) {
    const end = at + most
    const next = /[\uD800-\uDBFF]/.test(text[end - 1] ?? '') ? end - 1 : end
    yield text.slice(at, next)
    at = next
  }
}

async function* shortened(pieces: AsyncGenerator<string>): AsyncGenerator<string> {
  for await (const piece of pieces) yield* cut(piece)
}

type Slot = ReturnType<Slots['enter']>

/**
 * A JSON file that is written while it is sent, no faster than it is read: a class or a pupil as a whole might not fit into memory.
 * @param slot it begins when it is let in, and ends its slot when it has been sent or the reader disconnects
 */
export function streamed(pieces: AsyncGenerator<string>, name: string, slot: Slot): Response {
  const encoder = new TextEncoder()
  const short = shortened(pieces)
  let pause = 0
  const body = new ReadableStream<Uint8Array>(
    {
      async pull(controller) {
        try {
          await slot.entered
          await wait(pause)
          const next = await short.next()
          if (next.done !== true) {
            pause = next.value.length / speed
            return controller.enqueue(encoder.encode(next.value))
          }
          controller.close()
        } catch (error) {
          controller.error(error)
        }
        slot.end()
      },
      async cancel() {
        slot.end()
        await short.return(undefined)
      },
    },
    // Nothing is read before it is wanted.
    { highWaterMark: 0 },
  )
  const headers = {
    'content-type': 'application/octet-stream',
    'content-disposition': `attachment; filename*=UTF-8''${encodeURIComponent(`botgarten-${name}.json`)}`,
  }
  return new Response(body, { headers })
}

/** Items as JSON. */
export async function* textsOf(items: AsyncIterable<unknown>): AsyncGenerator<string> {
  for await (const item of items) yield JSON.stringify(item)
}

/** A JSON array, an item at a time. @param texts each the JSON of an item */
export async function* arrayOf(texts: AsyncIterable<string>): AsyncGenerator<string> {
  let mark = '['
  for await (const text of texts) {
    yield mark + text
    mark = ','
  }
  yield mark === '[' ? '[]' : ']'
}
