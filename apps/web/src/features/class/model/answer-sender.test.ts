import { afterEach, beforeEach, expect, test, vi } from 'vitest'
import { hasAnswered, noteAnswered, putAnswer, waitingAnswers } from '#storage/waiting-answers.ts'
import { AnswerSender, type Sent } from './answer-sender.ts'

const answer = (n: number) => ({
  key: 'a'.repeat(32),
  id: n.toString(16).padStart(32, '0'),
  code: 'owl-200',
  values: { 'go-on': 'yes' },
})
const minutes = 60_000

let reply: Sent
let sent: string[]
let stop: () => void
let sender: AnswerSender

function begin() {
  sender = new AnswerSender(({ id }) => {
    sent.push(id)
    return Promise.resolve(reply)
  })
  stop = sender.start()
}

beforeEach(() => {
  const page = new EventTarget()
  vi.stubGlobal('addEventListener', page.addEventListener.bind(page))
  vi.stubGlobal('removeEventListener', page.removeEventListener.bind(page))
  vi.stubGlobal('dispatchEvent', page.dispatchEvent.bind(page))
  const kept = new Map<string, string>()
  vi.stubGlobal('localStorage', {
    getItem: (key: string) => kept.get(key) ?? null,
    setItem: (key: string, text: string) => void kept.set(key, text),
    removeItem: (key: string) => void kept.delete(key),
  })
  vi.useFakeTimers()
  sent = []
  reply = 'taken'
  begin()
})
afterEach(() => {
  stop()
  vi.useRealTimers()
  vi.unstubAllGlobals()
})

test('an answer is sent within two minutes, and then waits no more', async () => {
  putAnswer(answer(1))
  expect(sent).toEqual([])
  await vi.advanceTimersByTimeAsync(2 * minutes)
  expect(sent).toEqual([answer(1).id])
  expect(waitingAnswers()).toEqual([])
})

test('what waits is what is sent, and nothing of the pupil', () => {
  putAnswer(answer(1))
  expect(Object.keys(waitingAnswers()[0]!).toSorted()).toEqual(['code', 'id', 'key', 'values'])
})

test('seconds of sending are by chance, from none to two minutes', async () => {
  const chosen = vi.spyOn(crypto, 'getRandomValues')
  for (const [n, share] of [0.01, 0.5, 0.99].entries()) {
    chosen.mockImplementation((into) => (((into as Uint32Array)[0] = share * 0x1_0000_0000), into))
    putAnswer(answer(n))
    await vi.advanceTimersByTimeAsync(share * 120_000 - 1000)
    expect(sent).toHaveLength(n)
    await vi.advanceTimersByTimeAsync(2000)
    expect(sent).toHaveLength(n + 1)
  }
  chosen.mockRestore()
})

test('with the cable pulled it waits, also over a new page, until the class takes it', async () => {
  reply = 'away'
  putAnswer(answer(1))
  await vi.advanceTimersByTimeAsync(20 * minutes)
  expect(sent.length).toBeGreaterThan(5)
  stop()
  reply = 'taken'
  begin()
  await vi.advanceTimersByTimeAsync(2 * minutes)
  expect(waitingAnswers()).toEqual([])
})

test('once the form was closed, what waits goes within twenty seconds', async () => {
  putAnswer(answer(1))
  putAnswer(answer(2))
  sender.wake(null)
  await vi.advanceTimersByTimeAsync(20_000)
  expect(sent).toHaveLength(2)
})

test('what came too late waits until the form is opened again', async () => {
  reply = 'closed'
  putAnswer(answer(1))
  await vi.advanceTimersByTimeAsync(30 * minutes)
  expect(sent).toHaveLength(1)
  reply = 'taken'
  sender.wake('a'.repeat(32))
  await vi.advanceTimersByTimeAsync(2 * minutes)
  expect(waitingAnswers()).toEqual([])
})

test('what the class takes under no circumstances is not sent for ever', async () => {
  reply = 'never'
  putAnswer(answer(1))
  await vi.advanceTimersByTimeAsync(30 * minutes)
  expect(sent).toHaveLength(1)
  expect(waitingAnswers()).toEqual([])
})

test('the pupil who has answered is not asked again, and who comes after is', () => {
  noteAnswered('fox', 'one')
  noteAnswered('fox', 'two')
  expect([hasAnswered('fox', 'one'), hasAnswered('fox', 'two'), hasAnswered('otter', 'one')]).toEqual([
    true,
    true,
    false,
  ])
  noteAnswered('otter', 'one')
  expect(hasAnswered('otter', 'one')).toBe(true)
})
