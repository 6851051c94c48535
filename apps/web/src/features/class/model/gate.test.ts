import { afterEach, beforeEach, expect, test, vi } from 'vitest'
import type { Picture } from '@botgarten/classroom/pictures'
import type { Ask, Reply } from '#storage/ask.ts'
import { freshDevice } from '#storage/testing/device.ts'
import { freshLocalStorage } from '#storage/testing/local.ts'
import { Gate } from './gate.svelte.ts'
import { arrive, stayHere } from './here.ts'
import { Member } from './member.svelte.ts'

const account = { pupil: 'p1', class: 'c1', nickname: 'Fox', className: '5b' }
const pictures = ['fox', 'owl', 'bee'] as unknown as readonly Picture[]
const refused = (code: string): Reply => ({ kind: 'refused', status: 401, code, facts: {} })
const me = (fresh: boolean): Reply => ({
  kind: 'done',
  body: {
    ...{ id: 'p1', nickname: 'Fox', fresh, hand: false, attention: null, inside: null, handouts: [] },
    ...{ asked: null, questions: [] },
    class: {
      ...{ id: 'c1', name: '5b', open: true, cards: null, level: null, gallery: true, asking: true },
    },
  },
})

let replies: { [path: string]: Reply }
let through: number
let member: Member
const gates: Gate[] = []
const ask: Ask = (_method, path) => Promise.resolve(replies[path] ?? { kind: 'away' })
function opens(): Gate {
  const gate = new Gate(member, () => (through += 1))
  gates.push(gate)
  return gate
}
const settle = async () => {
  for (let turns = 0; turns < 50; turns += 1) await new Promise((done) => setImmediate(done))
}

beforeEach(async () => {
  freshLocalStorage()
  vi.stubGlobal('sessionStorage', localStorage)
  freshLocalStorage()
  vi.stubGlobal('addEventListener', () => {})
  vi.stubGlobal('removeEventListener', () => {})
  vi.stubGlobal('document', new EventTarget())
  await freshDevice()
  replies = { '/me': me(true) }
  through = 0
  member = new Member(account, ask)
  // The stream of the class has tests of its own.
  vi.spyOn(member.live, 'start').mockImplementation(() => {})
})
afterEach(() => {
  for (const gate of gates.splice(0)) gate.close()
  vi.unstubAllGlobals()
})

test('a page that begins asks who is there, and lets the child in who says yes', async () => {
  const gate = opens()
  expect([gate.question, through]).toEqual(['asks', 0])
  await gate.yes()
  expect([gate.question, gate.busy, through]).toEqual([null, false, 1])
})

test('in a tab where the child has answered before, no question appears', async () => {
  stayHere('p1')
  const gate = opens()
  expect([gate.question, through]).toEqual([null, 1])
  await settle()
  expect([gate.question, through]).toEqual([null, 1])
})

test('who comes back sees whether its work has come, before the page opens', async () => {
  arrive('p1', 'back')
  const gate = opens()
  expect([gate.question, gate.coming, through]).toEqual(['back', 'comes', 0])
  await settle()
  expect(gate.coming).toBe('cannotCome')
  gate.goOn()
  expect([gate.question, through]).toEqual([null, 1])
})

test.each([
  ['the lesson is over', me(false), 'pictures'],
  ['the class cannot be reached, and nothing is proven', { kind: 'away' }, 'locked'],
  ['the class has signed this pupil out', refused('join'), 'signedOut'],
  ['the class has ended', refused('classEnded'), 'ended'],
  ['the class is hidden', refused('classHidden'), 'hidden'],
] as const)('a yes is not enough where %s', async (_, reply, question) => {
  replies['/me'] = reply
  const gate = opens()
  await gate.yes()
  expect([gate.question, gate.busy, through]).toEqual([question, false, 0])
})

test('a page that is open already is closed by a class that has ended', async () => {
  stayHere('p1')
  const end = vi.spyOn(member, 'end').mockResolvedValue()
  replies['/me'] = refused('classEnded')
  const gate = opens()
  await settle()
  expect([gate.question, end.mock.calls.length]).toEqual(['ended', 1])
})

test('three pictures are sent once, each of them shown once; wrong ones are shown again from the start', async () => {
  replies = { '/me': me(false), '/me/pictures': refused('wrongPictures') }
  const gate = opens()
  await gate.yes()
  await gate.show(pictures[0]!)
  await gate.show(pictures[0]!)
  await gate.show(pictures[1]!)
  expect(gate.shown).toEqual(pictures.slice(0, 2))
  await gate.show(pictures[2]!)
  expect([gate.shown, gate.question, gate.busy]).toEqual([[], 'pictures', false])
  expect(gate.refused).not.toBeNull()
  replies['/me/pictures'] = { kind: 'done', body: {} }
  for (const picture of pictures) await gate.show(picture)
  expect([gate.refused, gate.question]).toEqual([null, 'back'])
})
