import { beforeAll, expect, test } from 'vitest'
import { fetchWords } from '#words/message.ts'
import { idleNote } from './idle-note.ts'

beforeAll(() => fetchWords('network', 'blocks-network'))

test('a network that runs has no note; each other one says why it does not, and offers its own fix', () => {
  expect(idleNote(null, undefined)).toBeNull()
  const notes = (['off', 'behind', 'loose'] as const).map((idle) => idleNote(idle, undefined)!)
  expect(new Set(notes.map(({ title }) => title)).size).toBe(3)
  expect(notes[1]!.label).toBe(notes[2]!.label)
  expect(idleNote('loose', 'network.switchOn')!.label).not.toBe(notes[2]!.label)
})
