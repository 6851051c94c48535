import { parseProject } from '@botgarten/programs'
import fc from 'fast-check'
import { deflateSync, strToU8 } from 'fflate'
import { readFileSync } from 'node:fs'
import { expect, test } from 'vitest'
import { LinkError, readLink, writeLink } from './link.ts'

const read = (path: string) =>
  JSON.parse(readFileSync(new URL(`../../../../content/${path}`, import.meta.url), 'utf8')) as object
const friendship = parseProject({
  ...{ botgarten: 1, name: 'Größe 1½ 🌱', card: 'friendship', assets: {} },
  ...read('cards/network/05-friendship/solution.json'),
  world: read('worlds/friendship/world.json'),
})
const link = (await writeLink(friendship))!

/** Why a link is refused. Everything else that is thrown ends the test. */
function reasonOf(hash: string): string {
  try {
    readLink(hash)
    return 'taken'
  } catch (cause) {
    if (cause instanceof LinkError) return cause.reason
    throw cause
  }
}

/** A link as somebody makes it who knows how: the check is right, what is inside is not ours. */
function forged(text: string): string {
  const letters = Buffer.from(deflateSync(strToU8(text), { level: 9 })).toString('base64url')
  let hash = 0x811c9dc5
  for (const letter of letters) hash = Math.imul(hash ^ letter.charCodeAt(0), 0x01000193)
  return `#1.${(hash >>> 0).toString(36)}.${letters}`
}

test('a project comes out of its link as it went in', () => {
  expect(readLink(link)).toEqual(friendship)
  expect(readLink(`#${link}`)).toEqual(friendship)
})

test('the solution of a card travels in less than 4,000 letters that no program on the way changes', () => {
  expect(link.length).toBeLessThan(4000)
  expect(link).toMatch(/^[\w.-]+$/)
})

test('what a child has reached with a card stays at home', async () => {
  const solved = { ...friendship, progress: { starts: [0, 1], hints: 2 } }
  expect(readLink((await writeLink(solved))!)).toEqual(friendship)
})

/** The project with so many digits of a seeded stream, which do not compress to less than 3.3 bits each. */
function withNoise(digits: number) {
  let seed = 1
  const noise = Array.from({ length: digits }, () => (seed = (seed * 48271) % 2147483647) % 10).join('')
  const program = Object.values(friendship.programs)[0]!
  const block = (data: string, index: number) => ({ id: `n${index}`, type: 'text', data })
  const stack = { x: 0, y: 0, blocks: [noise.slice(0, 15_000), noise.slice(15_000)].map(block) }
  return { ...friendship, programs: { main: { ...program, stacks: [...program.stacks, stack] } } }
}

test('product.md 8: what is over 8 kB when compressed is no link', async () => {
  const large = withNoise(30_000)
  expect(parseProject(large)).toEqual(large)
  expect(await writeLink(large)).toBeNull()
})

test('product.md 8: what has exactly 8 kB is one', async () => {
  const bytesOf = async (digits: number) => {
    const letters = (await writeLink(withNoise(digits)))?.split('.')[2]
    return letters === undefined ? Infinity : Math.floor((letters.length * 3) / 4)
  }
  // The last size that is a link.
  let [fits, tooMany] = [0, 30_000]
  while (tooMany - fits > 1) {
    const middle = Math.floor((fits + tooMany) / 2)
    if ((await bytesOf(middle)) === Infinity) tooMany = middle
    else fits = middle
  }
  const sizes = await Promise.all(Array.from({ length: 40 }, (_, at) => bytesOf(fits - 20 + at)))
  expect(Math.max(...sizes.filter(Number.isFinite))).toBe(8000)
})

test('a link cut anywhere is refused as cut', () => {
  fc.assert(
    fc.property(fc.integer({ min: 0, max: link.length - 1 }), (length) => {
      expect(reasonOf(link.slice(0, length))).toBe('linkCut')
    }),
  )
})

test('a letter that was changed on the way is noticed', () => {
  fc.assert(
    fc.property(fc.integer({ min: 2, max: link.length - 1 }), fc.constantFrom(...'aZ9_-'), (at, letter) => {
      fc.pre(link[at] !== letter && link[at] !== '.')
      expect(reasonOf(link.slice(0, at) + letter + link.slice(at + 1))).toBe('linkCut')
    }),
  )
})

test('whatever stands behind the #, the answer is a reason and nothing else', () => {
  fc.assert(fc.property(fc.string({ maxLength: 200 }), (text) => reasonOf(text) !== 'taken'))
  fc.assert(
    fc.property(fc.string({ maxLength: 200 }), (text) => {
      expect(reasonOf(forged(text))).toBe('linkNotAProject')
    }),
  )
})

test('a few letters that hold thousands of times as much are refused before they are unpacked', () => {
  const bomb = forged(' '.repeat(5_000_000))
  expect(bomb.length).toBeLessThan(11_000)
  expect(reasonOf(bomb)).toBe('linkTooBig')
})

test('a link longer than 8 kB is not even looked into', () => {
  expect(reasonOf(`#1.0.${'A'.repeat(11_000)}`)).toBe('linkTooBig')
})

test('a key that reaches into every object is refused', () => {
  const text = JSON.stringify(friendship).replace(
    '"programs":{',
    '"programs":{"__proto__":{"polluted":true},',
  )
  expect(reasonOf(forged(text))).toBe('linkNotAProject')
})

test('a link of a later version says so', () => {
  expect(reasonOf('#2.abc.def')).toBe('linkNewer')
  expect(reasonOf('#12.abc')).toBe('linkNewer')
})

test('a project that no reader would unpack, or open, gets no link, however small it is', async () => {
  const letters = (count: number) => ({
    id: `b${count}`,
    type: 'text',
    fields: { TEXT: 'x'.repeat(count) },
  })
  const withBlocks = (blocks: ReturnType<typeof letters>[]) => ({
    ...friendship,
    programs: { main: { stacks: [{ x: 0, y: 0, blocks }], config: { stacks: [] } } },
  })
  const many = (count: number) => Array.from({ length: count }, (_, k) => letters(19_000 - k))
  const fits = withBlocks(many(50))
  expect(readLink((await writeLink(fits))!)).toEqual(fits)
  expect(await writeLink(withBlocks(many(60)))).toBeNull()
  expect(await writeLink(withBlocks([letters(20_001)]))).toBeNull()
})
