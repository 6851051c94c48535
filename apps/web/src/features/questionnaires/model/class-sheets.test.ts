import content from 'content:questionnaires'
import { migrate, openSqlite } from '@botgarten/classroom'
import { quickAccounts, Server } from '@botgarten/classroom/testing'
import { permitOf } from '@botgarten/classroom/testing/devices'
import { strFromU8, unzipSync } from 'fflate'
import { beforeEach, expect, test } from 'vitest'
import { ClassSheets } from './class-sheets.svelte.ts'
import { tablesOf } from './tables.ts'

let server: Server
let sheets: ClassSheets
let code: string
let id: string
let teacher: Awaited<ReturnType<Server['firstTeacher']>>

beforeEach(async () => {
  const database = openSqlite(':memory:')
  await migrate(database)
  server = new Server(database, quickAccounts(database))
  teacher = await server.firstTeacher()
  ;({ id, code } = await server.openClass(teacher))
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
  expect(sheets.loaded).toBe(false)
  await sheets.load()
  expect([sheets.askings, sheets.loaded]).toEqual([[], true])
  await sheets.open(after)
  await answer(6)
  await sheets.load()
  expect([sheets.isOpen('after'), sheets.count('after'), sheets.isMoving]).toEqual([true, 6, true])
  expect(sheets.tallies(after)).toEqual([])
  await sheets.open(before)
  expect(sheets.refused).toBe('otherFormOpen')
  // The page looks every five seconds: the sentence stays until the teacher does something that succeeds.
  await sheets.load()
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
})

test('a form of the class comes back as it was asked', async () => {
  const own = { form: { ...after.form, id: 'after-2' }, text: after.text }
  await sheets.open(own)
  expect(sheets.forms.map(({ form, text }) => [form.id, text['en']!.title])).toEqual([
    ['after-2', after.text['en']!.title],
  ])
})

async function close(form: string) {
  sheets.close(form)
  await expect.poll(() => sheets.of(form)?.state).toBe('closing')
  server.later(2)
  await sheets.load()
}

test('the tables of a form come with a book of what each column and value means', async () => {
  await sheets.open(after)
  await answer(6)
  await close('after')
  const files = unzipSync(await tablesOf(sheets, after))
  expect(Object.keys(files)).toContain('after-take-along.csv')
  const [head, ...lines] = strFromU8(files['code-book.csv']!).split(/\r?\n/)
  expect(head).toContain('column,kind,question,values,right')
  const words = after.text['en']!.words
  const row = lines.find((line) => line.startsWith('interest-supervised,scale,'))!
  expect(row).toContain(words['interest-supervised']!['question'])
  for (const step of ['1', '2', '3', '4', '5']) expect(row).toContain(`${step} = ${words['interest']![step]}`)
})

test('a class of grade 4 has results of grades 3 and 4', async () => {
  expect((await teacher.patch(`/classes/${id}`, { grade: 4 })).status).toBeLessThan(300)
  await sheets.open(after)
  await answer(6)
  await close('after')
  expect(sheets.refused).toBeNull()
  expect(sheets.tallies(after).map(({ bands }) => bands)).toEqual([['3-4']])
})

test('counts from paper are added to a closed form, and removed again', async () => {
  await sheets.open(after)
  await answer(6)
  await close('after')
  await sheets.addPaper({ form: 'after', bands: ['5-6'], n: 5, counts: { 'go-on': [5, 0, 0] }, open: {} })
  expect([sheets.refused, sheets.of('after')!.paper]).toEqual([null, 5])
  await sheets.removePaper('after')
  expect([sheets.refused, sheets.of('after')!.paper]).toEqual([null, 0])
})

test('a pupil whose answer got lost may answer once more, and only once', async () => {
  await sheets.open(after)
  const { id: pupil, browser } = await server.pupil(code, 'Fuchs')
  await permitOf(browser)
  expect(await sheets.allowAgain('after', pupil)).toBe('allowed')
  await permitOf(browser)
  expect(await sheets.allowAgain('after', pupil)).toBe('before')
  expect(await sheets.allowAgain('before', pupil)).toBe('failed')
})

test('what a class knew before and after is joined by the codes of its children', async () => {
  const children = await Promise.all(
    [0, 1, 2, 3, 4, 5].map(async (n) => (await server.pupil(code, `Kind ${n}`)).browser),
  )
  for (const loaded of [before, after]) {
    await sheets.open(loaded)
    for (const [n, child] of children.entries())
      await server
        .browser()
        .post('/answers', { ...(await permitOf(child)), code: `owl-${200 + n}`, values: {} })
    await close(loaded.form.id)
  }
  const [joined, ...others] = sheets.growths([before, after])
  expect([joined!.before, joined!.after, joined!.growth.n, others]).toEqual([before, after, 6, []])
  // A form that is not shown here is compared with nothing.
  expect(sheets.growths([after])).toEqual([])
})
