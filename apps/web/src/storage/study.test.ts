import { beforeEach, expect, test } from 'vitest'
import { listBin, throwAway } from './bin.ts'
import { list, save } from './projects.ts'
import { deleteChild, deleteLogs, logFile, projectsOf, putLines } from './study.ts'
import { freshDevice } from './testing/device.ts'
import { fear } from './testing/sample.ts'

const line = (pseudonym: string) => ({ pseudonym, session: pseudonym, began: 1, n: 0, text: pseudonym })

beforeEach(async () => {
  await freshDevice()
  await deleteLogs()
})

test('deleting a child deletes its log and its projects, also in the bin, and nothing of other children', async () => {
  await putLines([line('0101A'), line('0102B')])
  for (const pseudonym of ['0101A', '0102B'])
    for (const card of ['fear', 'thrown']) await save(`${projectsOf(pseudonym)}${card}`, fear, 0)
  await save('fear', fear, 0)
  await throwAway('study-0101A-thrown')
  await throwAway('study-0102B-thrown')
  await deleteChild('0101A')
  expect(await logFile()).toBe('0102B\n')
  const { projects } = await list()
  expect(projects.map(({ id }) => id).sort()).toEqual(['fear', 'study-0102B-fear'])
  expect((await listBin()).thrown.map(({ was }) => was)).toEqual(['study-0102B-thrown'])
})
