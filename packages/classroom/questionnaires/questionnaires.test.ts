import { beforeAll, describe, expect, test } from 'vitest'
import { content } from '@botgarten/content/files'
import { writeFormFile } from '@botgarten/content/questionnaires'
import { onBothDatabases } from '../testing/databases.ts'
import type { Browser } from '../testing/browser.ts'
import { quickAccounts, Server } from '../testing/world.ts'
import { everyNight } from '../teaching/every-night.ts'
import { answerOf } from './testing/children.ts'
import { askedOn, permitOf, type Permit } from './testing/devices.ts'

interface Shown {
  readonly askings: readonly {
    readonly form: { readonly id: string }
    readonly state: string
    readonly seconds: number | null
    readonly came: number | null
  }[]
}
interface Results {
  readonly forms: readonly {
    readonly form: string
    readonly tallies: readonly {
      readonly n: number
      readonly counts: { readonly [item: string]: readonly number[] }
      readonly open: { readonly [item: string]: readonly string[] }
    }[]
  }[]
  readonly growths: readonly {
    readonly before: string
    readonly after: string
    readonly growth: { readonly n: number; readonly scores: readonly (readonly [number, number])[] }
  }[]
}

onBothDatabases((fresh) => {
  let server: Server
  let teacher: Browser

  beforeAll(async () => {
    const database = await fresh()
    server = new Server(database, quickAccounts(database))
    teacher = await server.firstTeacher()
  })

  /** A class with a pupil, and what can be done with its questionnaires. */
  async function school() {
    const { id, code } = await server.openClass(teacher)
    const { browser: child } = await server.pupil(code, 'Fuchs')
    const devices = new Map<number, Promise<Browser>>()
    const deviceOf = (n: number) => {
      const found = devices.get(n) ?? server.pupil(code, `Kind ${n}`).then(({ browser }) => browser)
      devices.set(n, found)
      return found
    }
    const permits = new Map<string, Promise<Permit>>()
    const at = `/classes/${id}/questionnaires`
    return {
      ...{ id, code, child, at },
      /** Key, id and token of the answer of the n-th child to the form that is open. */
      permit: (n: number, form = 'after') => {
        const found = permits.get(`${form} ${n}`) ?? deviceOf(n).then((device) => permitOf(device))
        permits.set(`${form} ${n}`, found)
        return found
      },
      open: (form = 'after') => teacher.post(at, { form }),
      /** Closes it and waits until what is on its way has had its time. */
      close: async (form = 'after') => {
        const answer = await teacher.post(`${at}/${form}/close`)
        server.later(2)
        return answer
      },
      key: async () => (await askedOn(child)).key,
      list: async () => ((await teacher.get(at)).body as Shown).askings,
      results: async () => (await teacher.get(`${at}/results`)).body as Results,
    }
  }
  type School = Awaited<ReturnType<typeof school>>

  /** So many children answer what is open, each from a device that sends no cookie. */
  async function answer(one: School, form: string, children: readonly number[]) {
    for (const child of children) expect((await send(one, form, child)).status).toBe(204)
  }
  const send = async (one: School, form: string, child: number, more: object = {}) =>
    server
      .browser(`192.168.1.${child}`)
      .post('/answers', { ...(await one.permit(child, form)), ...answerOf(form, child), ...more })
  const first = (count: number, from = 0) => Array.from({ length: count }, (_, at) => from + at)

  test('a pupil is asked what the teacher opens, and no more once it is closed', async () => {
    const one = await school()
    expect((await one.child.get('/me')).body).toMatchObject({ asking: null })
    expect((await one.child.get('/me/questionnaire?tokens')).status).toBe(404)
    await one.open()
    const { body } = await one.child.get('/me/questionnaire?tokens')
    expect(body).toMatchObject({ grade: 5, form: { id: 'after' } })
    expect((await one.child.get('/me')).body).toMatchObject({ asking: (body as { key: string }).key })
    expect((await one.open('before')).body).toEqual({ error: 'otherFormOpen' })
    await one.close()
    expect((await one.child.get('/me')).body).toMatchObject({ asking: null })
  })

  test('an answer that is sent twice, because the network was lost, is one', async () => {
    const one = await school()
    await one.open()
    await answer(one, 'after', [0, 1, 2, 3, 4, 5, 0, 0, 3])
    expect(await one.list()).toMatchObject([{ state: 'open', came: 6 }])
  })

  test('fewer than five are not counted out, and give no results', async () => {
    const one = await school()
    await one.open()
    expect((await one.list())[0]!.came).toBe(0)
    await answer(one, 'after', first(4))
    expect((await one.list())[0]!.came).toBeNull()
    await one.close()
    expect((await one.results()).forms).toEqual([{ form: 'after', tallies: [] }])
  })

  test('there are results of what is closed and has had its minute, and of nothing else', async () => {
    const one = await school()
    await one.open()
    await answer(one, 'after', first(6))
    expect((await one.results()).forms).toEqual([])
    expect((await teacher.get(`${one.at}/after/rows`)).body).toEqual({ error: 'formOpen' })
    await one.permit(6)
    await teacher.post(`${one.at}/after/close`)
    // What was on its way is taken for a minute.
    expect((await send(one, 'after', 6)).status).toBe(204)
    expect(await one.list()).toMatchObject([{ state: 'closing', seconds: 60 }])
    expect((await one.results()).forms).toEqual([])
    server.later(2)
    const [{ tallies }] = (await one.results()).forms as [Results['forms'][number]]
    expect(tallies.map(({ n }) => n)).toEqual([7])
    expect(tallies[0]!.counts['interest-supervised']).toEqual([2, 2, 1, 1, 1])
    expect(tallies[0]!.open['take-along']!.toSorted()).toEqual(first(7).map((n) => `Satz ${n}`))
    const { rows } = (await teacher.get(`${one.at}/after/rows`)).body as { rows: readonly unknown[][] }
    expect(rows).toHaveLength(8)
    expect(JSON.stringify(rows)).not.toMatch(/owl|Satz|2026/)
  })

  test('a closed form takes no answer, and one that it has is acknowledged again', async () => {
    const one = await school()
    await one.open()
    await answer(one, 'after', first(5))
    await one.permit(9)
    await one.close()
    const late = await send(one, 'after', 9)
    expect(late).toMatchObject({ status: 409, body: { error: 'formClosed' } })
    expect((await send(one, 'after', 3)).status).toBe(204)
  })

  test('opened again, results change once five more have come', async () => {
    const one = await school()
    await one.open()
    await answer(one, 'after', first(6))
    await one.close()
    const before = await one.results()
    await one.open()
    expect((await one.results()).forms).toEqual([])
    await answer(one, 'after', first(4, 10))
    await one.close()
    const counts = ({ forms }: Results) => forms.map(({ tallies }) => tallies.map((tally) => tally.counts))
    expect(counts(await one.results())).toEqual(counts(before))
    await one.open()
    await answer(one, 'after', [20])
    await one.close()
    expect((await one.results()).forms[0]!.tallies[0]!.n).toBe(11)
  })

  test('counts from five sheets of paper or more are added to the results', async () => {
    const one = await school()
    await one.open()
    await answer(one, 'after', first(6))
    await one.close()
    const sheets = { bands: ['5-6'], n: 5, counts: { 'go-on': [5, 0, 0] }, open: {} }
    const add = (more: object) => teacher.post(`${one.at}/after/paper`, { ...sheets, ...more })
    expect((await add({ n: 4 })).status).toBe(400)
    expect((await add({ bands: ['13'] })).status).toBe(400)
    expect((await add({})).status).toBe(204)
    expect(await one.list()).toMatchObject([{ came: 6, paper: 5 }])
    // 7 pupils: Fuchs and the six who have answered.
    expect(await add({})).toMatchObject({ status: 409, body: { error: 'tooManySheets' } })
    const shown = async () =>
      (await one.results()).forms[0]!.tallies.map((tally) => [tally.n, tally.counts['go-on']])
    expect(await shown()).toEqual([[11, [7, 2, 2]]])
    await teacher.delete(`${one.at}/after/paper`)
    expect(await shown()).toEqual([[6, [2, 2, 2]]])
  })

  test('sheets of paper are at most one a pupil, also if they are typed in twice at the same moment', async () => {
    const one = await school()
    await one.open()
    for (const n of first(11)) await one.permit(n)
    const add = () =>
      teacher.post(`${one.at}/after/paper`, {
        bands: ['5-6'],
        n: 6,
        counts: { 'go-on': [6, 0, 0] },
        open: {},
      })
    const answers = await Promise.all([add(), add(), add()])
    // 12 pupils: two of the three times six sheets.
    expect(answers.map(({ status }) => status).toSorted()).toEqual([204, 204, 409])
    expect(await one.list()).toMatchObject([{ paper: 12 }])
    await teacher.delete(`${one.at}/after/paper`)
    expect((await add()).status).toBe(204)
  })

  test('before and after are joined by codes, from five on', async () => {
    const one = await school()
    for (const form of ['before', 'after']) {
      await one.open(form)
      await answer(one, form, first(6))
      await one.close(form)
    }
    const [{ before, after, growth }] = (await one.results()).growths as [Results['growths'][number]]
    expect([before, after, growth.n]).toEqual(['before', 'after', 6])
  })

  test('the second child with a code hears that it is taken; a device may ask for its own again', async () => {
    const one = await school()
    await one.open('before')
    const choose = async (child: number, code: string) =>
      (await server.browser().post('/answers/code', { ...(await one.permit(child, 'before')), code })).body
    expect(await choose(1, 'owl-200')).toEqual({ taken: false })
    expect(await choose(2, 'owl-200')).toEqual({ taken: true })
    expect(await choose(1, 'owl-200')).toEqual({ taken: false })
    expect(await choose(1, 'owl-201')).toEqual({ taken: false })
    expect(await choose(2, 'owl-200')).toEqual({ taken: false })
    await send(one, 'before', 2, { code: 'owl-200' })
    expect(await choose(3, 'owl-200')).toEqual({ taken: true })
    expect(await choose(4, 'emu-200')).toEqual({ error: 'notUnderstood' })
  })

  test('"I forgot it" is an answer', async () => {
    const one = await school()
    await one.open()
    expect((await send(one, 'after', 1, { code: null })).status).toBe(204)
  })

  test('what is no answer is refused, and what the form does not ask is not kept', async () => {
    const one = await school()
    await one.open()
    for (const more of [{ id: 'x' }, { code: 'owl' }, { day: '2026-11-26' }, { values: { 'go-on': 7 } }])
      expect((await send(one, 'after', 1, more)).status).toBe(400)
    expect((await send(one, 'after', 1, { key: 'f'.repeat(32) })).body).toEqual({ error: 'noSuchForm' })
    const values = { nickname: 'Fuchs', 'go-on': 'never', 'take-along': 'viel' }
    expect((await send(one, 'after', 1, { values })).status).toBe(204)
    const rows = await server.ports.database.answers.db.selectFrom('answer').select('chosen').execute()
    expect(rows.map(({ chosen }) => chosen)).toContain('{"take-along":"viel"}')
    expect(JSON.stringify(rows)).not.toMatch(/nickname|never/)
  })

  test('an answer comes without a cookie, and none is set', async () => {
    const one = await school()
    await one.open()
    const sent = { ...(await one.permit(1)), ...answerOf('after', 1) }
    expect(await one.child.post('/answers', sent)).toMatchObject({
      status: 400,
      body: { error: 'withCookie' },
    })
    const { headers } = await server.browser().post('/answers', sent)
    expect(headers.getSetCookie()).toEqual([])
  })

  describe('a form of a teacher’s own', () => {
    const after = content.forms.find(({ form }) => form.id === 'after')!
    const own = (title: string) => {
      const form = { ...after.form, id: 'after-2' }
      const text = Object.fromEntries(
        Object.entries(after.text).map(([language, words]) => [language, { ...words, title }]),
      )
      return JSON.parse(writeFormFile({ form, text })) as object
    }

    test('is asked as it is, in these words alone', async () => {
      const one = await school()
      expect((await teacher.post(one.at, { own: own('Unser Tag') })).status).toBe(204)
      expect((await one.child.get('/me/questionnaire?tokens')).body).toMatchObject({
        text: { en: { title: 'Unser Tag' } },
      })
      await one.close('after-2')
      expect((await teacher.post(one.at, { own: own('Anders') })).body).toEqual({ error: 'formChanged' })
      expect((await teacher.post(one.at, { own: own('Unser Tag') })).status).toBe(204)
    })

    test('does not take the place of one of the product’s, and is read by the parser of forms', async () => {
      const one = await school()
      const file = own('Nach dem Tag') as { form: object }
      const refused = { status: 422, body: { error: 'formRefused' } }
      expect(await teacher.post(one.at, { own: { ...file, form: after.form } })).toMatchObject(refused)
      expect(await teacher.post(one.at, { own: { ...file, text: {} } })).toMatchObject(refused)
      expect((await teacher.post(one.at, { form: 'no-such-form' })).status).toBe(404)
    })
  })

  test('a class that is deleted takes its answers along, also where it is gone by a restore', async () => {
    const { db } = server.ports.database.answers
    const rowsAbout = async (id: string) => {
      const askings = await db.selectFrom('asking').select('key').where('class', '=', id).execute()
      const published = await db.selectFrom('published').selectAll().where('class', '=', id).execute()
      return askings.length + published.length
    }
    const asked = async () => {
      const one = await school()
      await one.open()
      await answer(one, 'after', first(6))
      await one.close()
      await one.results()
      expect(await rowsAbout(one.id)).toBe(2)
      return one
    }
    const [gone, lost] = [await asked(), await asked()]
    await teacher.delete(`/classes/${gone.id}`, { name: '5b' })
    expect(await rowsAbout(gone.id)).toBe(0)
    await server.ports.database.db.deleteFrom('class').where('id', '=', lost.id).execute()
    await everyNight(server.ports)
    expect(await rowsAbout(lost.id)).toBe(0)
    const keys = await db.selectFrom('asking').select('key').execute()
    const rows = await db.selectFrom('answer').select('asking').execute()
    expect(rows.filter(({ asking }) => !keys.some(({ key }) => key === asking))).toEqual([])
  })

  test('what nobody looks at after it was closed is settled in the night', async () => {
    const one = await school()
    await one.open()
    await answer(one, 'after', first(5))
    await one.close()
    await everyNight(server.ports)
    const { db } = server.ports.database.answers
    const row = await db.selectFrom('asking').select('state').where('class', '=', one.id).executeTakeFirst()
    expect(row).toEqual({ state: 'closed' })
  })
})
