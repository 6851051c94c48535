import { expect, test } from 'vitest'
import { Slots } from '../slots.ts'
import { streamed } from './streamed.ts'

async function* piecesOf(...texts: readonly string[]) {
  for (const text of texts) yield await Promise.resolve(text)
}

const open = (...texts: readonly string[]) => {
  const slots = new Slots(1, 1)
  return { slots, response: streamed(piecesOf(...texts), 'class', slots.enter('weber')) }
}

test('a long piece is sent in short ones, and no letter of two code units is cut', async () => {
  // The first code unit of the letter is the last one of the first short piece.
  const text = `${'a'.repeat(249_999)}🦊${'b'.repeat(300_000)}`
  const { response } = open('[', text, ']')
  const lengths: number[] = []
  const decoder = new TextDecoder()
  let all = ''
  for await (const piece of response.body! as unknown as AsyncIterable<Uint8Array>) {
    lengths.push(piece.length)
    all += decoder.decode(piece, { stream: true })
  }
  expect(all).toBe(`[${text}]`)
  // 🦊 has four bytes.
  expect(lengths).toEqual([1, 249_999, 4 + 249_998, 50_002, 1])
})

test.each(['read to its end', 'closed early'])(
  'a file that is %s makes room for the next one',
  async (how) => {
    const { slots, response } = open('[', '1', ']')
    const next = slots.enter('weber')
    if (how === 'closed early') await response.body!.cancel()
    else expect(await response.text()).toBe('[1]')
    await next.entered
  },
)

test('a file that cannot be read to its end fails, and makes room for the next one', async () => {
  const slots = new Slots(1, 1)
  async function* broken() {
    yield await Promise.resolve('[')
    throw new Error('The disk is gone.')
  }
  const response = streamed(broken(), 'class', slots.enter('weber'))
  const next = slots.enter('weber')
  await expect(response.text()).rejects.toThrow('The disk is gone.')
  await next.entered
})
