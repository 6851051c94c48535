import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest'
import type { Source } from '#parts/page/source.ts'
import type { Me } from './pupil.ts'
import { holdWhileSeen, SharedStream, type Channel } from './shared-stream.ts'

const me = (nickname: string): Me => ({
  ...{ id: 'p', nickname, fresh: true, hand: false, attention: null, inside: null, handouts: [], pair: null },
  ...{ asking: null, asked: null, questions: [] },
  class: {
    id: 'c',
    name: '5b',
    open: true,
    cards: null,
    level: null,
    gallery: true,
    asking: false,
    together: false,
  },
})

/** A stream whose events a test sends. */
class HandSource implements Source {
  readyState = 1
  readonly #hear = new Map<string, (event: { readonly data: string }) => void>()
  addEventListener(name: string, hear: (event: { readonly data: string }) => void) {
    this.#hear.set(name, hear)
  }
  close() {
    this.readyState = 2
  }
  send(name: string, data: unknown) {
    this.#hear.get(name)?.({ data: JSON.stringify(data) })
  }
}

/** Pages of one browser: what one of them says the others hear at once. */
class Pages {
  readonly sources: HandSource[] = []
  readonly #channels: Channel[] = []

  open(): { stream: SharedStream; heard: string[] } {
    const heard: string[] = []
    const channel: Channel = {
      onmessage: null,
      postMessage: (data: unknown) => {
        for (const other of this.#channels)
          if (other !== channel) (other.onmessage as ((event: object) => void) | null)?.({ data })
      },
      close: () => void this.#channels.splice(this.#channels.indexOf(channel), 1),
    }
    this.#channels.push(channel)
    const stream = new SharedStream(
      { state: (now) => heard.push(now.me.nickname), end: (reason) => heard.push(`end: ${reason}`) },
      () => {
        const source = new HandSource()
        this.sources.push(source)
        return source
      },
      channel,
    )
    return { stream, heard }
  }
  /** Streams that stand. */
  get standing() {
    return this.sources.filter(({ readyState }) => readyState < 2)
  }
}

let pages: Pages
beforeEach(() => {
  vi.useFakeTimers()
  pages = new Pages()
})
afterEach(() => void vi.useRealTimers())

const later = () => vi.advanceTimersByTime(1)

describe('pages of one browser', () => {
  test('have one stream: the page that was used last holds it, and the others hear the same', () => {
    const one = pages.open()
    const two = pages.open()
    one.stream.take()
    pages.sources[0]!.send('state', me('Fuchs'))
    later()
    two.stream.take()
    expect(pages.standing).toHaveLength(1)
    expect([one.stream.isHeld, two.stream.isHeld]).toEqual([false, true])
    pages.sources[1]!.send('state', me('Dachs'))
    expect([one.heard, two.heard]).toEqual([
      ['Fuchs', 'Dachs'],
      ['Fuchs', 'Dachs'],
    ])
  })

  test('that is closed leaves the stream to another one', () => {
    const one = pages.open()
    const two = pages.open()
    one.stream.take()
    one.stream.close()
    expect(two.stream.isHeld).toBe(true)
    expect(pages.standing).toHaveLength(1)
  })

  test('that broke down without a word are followed after 15 s', () => {
    const one = pages.open()
    one.stream.take()
    const two = pages.open()
    vi.advanceTimersByTime(14_000)
    two.stream.beat()
    expect(two.stream.isHeld).toBe(false)
    vi.advanceTimersByTime(2000)
    two.stream.beat()
    expect(two.stream.isHeld).toBe(true)
  })

  test('stay with the one that says every few seconds that it is well', () => {
    const one = pages.open()
    const two = pages.open()
    one.stream.take()
    pages.sources[0]!.send('state', me('Fuchs'))
    for (let seconds = 0; seconds < 60; seconds += 5) {
      vi.advanceTimersByTime(5000)
      one.stream.beat()
      two.stream.beat()
    }
    expect([one.stream.isHeld, two.stream.isHeld]).toEqual([true, false])
  })

  test('hear all of them that the lesson is over; a stream that only got old is opened again', () => {
    const one = pages.open()
    const two = pages.open()
    one.stream.take()
    pages.sources[0]!.send('end', { reason: 'again' })
    expect(pages.standing).toHaveLength(1)
    pages.sources[1]!.send('end', { reason: 'closed' })
    expect([one.heard, two.heard]).toEqual([['end: closed'], ['end: closed']])
    expect(pages.standing).toHaveLength(0)
  })

  test('open a stream again that the server has refused', () => {
    const { stream } = pages.open()
    stream.take()
    pages.sources[0]!.close()
    pages.sources[0]!.send('error', null)
    vi.advanceTimersByTime(3000)
    expect(pages.standing).toHaveLength(1)
    stream.close()
  })
})

test('a page that is hidden leaves the stream to others, and takes it again when it is seen', () => {
  const page = Object.assign(new EventTarget(), { visibilityState: 'visible' })
  vi.stubGlobal('document', page)
  vi.stubGlobal('addEventListener', () => {})
  vi.stubGlobal('removeEventListener', () => {})
  const turns = (visibilityState: string) => {
    Object.assign(page, { visibilityState })
    page.dispatchEvent(new Event('visibilitychange'))
  }
  const { stream } = pages.open()
  const stop = holdWhileSeen(stream)
  expect(stream.isHeld).toBe(true)
  turns('hidden')
  expect([stream.isHeld, pages.standing.length]).toEqual([false, 0])
  turns('visible')
  expect([stream.isHeld, pages.standing.length]).toEqual([true, 1])
  stop()
  turns('hidden')
  expect(stream.isHeld).toBe(true)
  vi.unstubAllGlobals()
})
