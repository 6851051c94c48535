import content from 'content:questionnaires'
import { migrate, openSqlite } from '@botgarten/classroom'
import { quickAccounts, Server } from '@botgarten/classroom/testing'
import { permitOf } from '@botgarten/classroom/testing/devices'
import { beforeEach, expect, test } from 'vitest'
import { ClassSheets } from './class-sheets.svelte.ts'
import { tablesOf } from './tables.ts'

let server: Server
let sheets: ClassSheets
let code: string

beforeEach(async () => {
  const database = openSqlite(':memory:')
  await migrate(database)
  server = new Server(database, quickAccounts(database))
  const teacher = await server.firstTeacher()
  const opened = await server.openClass(teacher)
  const { id } = opened
  code = opened.code
  sheets = new ClassSheets(async (method, path, body) => {
    const answer = await teacher.ask(method, `/classes/${id}${path}`, body)
    if (answer.status < 400) return answer.body
    throw Object.assign(new Error(), { code: (answer.body as { error: string }).error })
  })
})

const after = content.forms.find(({ form }) => form.id === 'after')!
const before = content.forms.find(({ form }) => form.id === 'before')!

async function answer(count: number) {
  for (let n = 0; n < count; n++) {
    const values = { 'interest-supervised': '4', 'take-along': `Bo ${n}` }
    const { browser } = await server.pupil(code, `Kind ${n}`)
    await server.browser().post('/answers', { ...(await permitOf(browser)), code: null, values })
  }
}

test('a class is asked, counted, and has results once it is closed', async () => {
  await sheets.load()
  expect(sheets.askings).toEqual([])
  await sheets.open(after)
  await answer(6)
  await sheets.load()
  expect([sheets.isOpen('after'), sheets.count('after'), sheets.isMoving]).toEqual([true, 6, true])
  expect(sheets.tallies(after)).toEqual([])
  await sheets.open(before)
  expect(sheets.refused).toBe('otherFormOpen')
  sheets.close('after')
  await expect.poll(() => sheets.of('after')?.state).toBe('closing')
  server.later(2)
  await sheets.load()
  expect([sheets.isOpen('after'), sheets.isMoving, sheets.refused]).toEqual([false, false, null])
  const [tally] = sheets.tallies(after)
  expect([tally!.n, tally!.bands, tally!.counts['interest-supervised']]).toEqual([
    6,
    ['5-6'],
    [0, 0, 0, 6, 0],
  ])
  expect(await sheets.rows(after)).toHaveLength(7)
  expect((await tablesOf(sheets, after)).length).toBeGreaterThan(500)
})

test('a form of the class comes back as it was asked', async () => {
  const own = { form: { ...after.form, id: 'after-2' }, text: after.text }
  await sheets.open(own)
  expect(sheets.forms.map(({ form, text }) => [form.id, text['en']!.title])).toEqual([
    ['after-2', after.text['en']!.title],
  ])
})
