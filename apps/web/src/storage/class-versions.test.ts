import { beforeEach, expect, test } from 'vitest'
import { noteCompared, seenMark } from './class-versions.ts'
import { nextToSend, noteAnswer } from './outbox.ts'
import { save } from './projects.ts'
import { freshDevice } from './testing/device.ts'
import { fear } from './testing/sample.ts'

beforeEach(freshDevice)

/** Saves a project, and the class answers with this mark. */
async function savesWith(id: string, mark: string) {
  await save(id, fear, 0)
  const sent = (await nextToSend())!
  await noteAnswer(sent, { kind: 'saved', revision: 1, hash: id, mark })
}

test('an answer of the class that arrives late does not replace the newer mark', async () => {
  await savesWith('first', '2.b')
  await savesWith('second', '1.a')
  expect(await seenMark()).toBe('2.b')
  await savesWith('third', '10.c')
  expect(await seenMark()).toBe('10.c')
})

test('the mark of a restored class replaces the newer mark that it has lost', async () => {
  await savesWith('first', '2.b')
  await noteCompared({ projects: [], bin: [], mark: '1.a', known: true })
  expect(await seenMark()).toBe('2.b')
  await noteCompared({ projects: [], bin: [], mark: '1.a', known: false })
  expect(await seenMark()).toBe('1.a')
  await noteCompared({ projects: [], bin: [], mark: null, known: false })
  expect(await seenMark()).toBeNull()
})
