import { beforeAll, expect, test } from 'vitest'
import type { Route } from './route.ts'
import { routes } from './routes.ts'
import { onBothDatabases } from './testing/databases.ts'
import type { Browser } from './testing/browser.ts'
import { projectText } from './testing/projects.ts'
import { quickAccounts, Server } from './testing/world.ts'
import type { Role } from './who.ts'

/** What each route is sent so that only the sender's role decides. */
const bodies: { readonly [route: string]: unknown } = {
  'POST /teachers': { token: 'none', username: 'somebody', password: 'ein langer satz' },
  'POST /auth/sign-in/username': { username: 'nobody', password: 'wrong' },
  'POST /teachers/me/password': { password: 'wrong', newPassword: 'ein langer satz' },
  'DELETE /teachers/me': { password: 'wrong' },
  'DELETE /teachers/:teacher': { username: 'nobody' },
  'POST /look': { code: 'a' },
  'POST /join': { code: 'a', nickname: 'Otter' },
  'POST /return': { code: 'a', nickname: 'Otter', pictures: ['boat', 'key', 'leaf'] },
  'POST /me/pictures': { pictures: ['boat', 'key', 'leaf'] },
  'PUT /me/hand': { up: true },
  'PUT /projects/:project': projectText('b'),
  'POST /classes': { name: '7c', language: 'de', grade: 7, endsOn: '2027-07-31' },
  'PATCH /classes/:class': { grade: 6 },
  'DELETE /classes/:class': { name: '5b' },
  'PATCH /classes/:class/pupils/:pupil': { nickname: 'Neuer Name' },
  'PUT /me/here': {
    ...{ card: 'friendship', project: null, checks: ['open'], failed: 0, running: true, idle: 2 },
    ...{ size: [200, 150], pose: { x: 1, y: 2, heading: 0.5 }, trail: [1, 2] },
  },
  'PUT /classes/:class/wifi': { name: 'Aula', password: 'sonnenschein' },
  'PUT /classes/:class/attention': { on: false },
  'PUT /classes/:class/free': { cards: null, level: null },
  'POST /classes/:class/handouts': { to: 'all', kind: 'hint', card: 'friendship', hint: 1 },
  'POST /classes/:class/programs': projectText('c'),
  'POST /substitute': { token: 'none' },
  'POST /rehearsal': { pupils: 2, seconds: 1 },
  'POST /clock': { right: false, today: '2026-11-24' },
  'POST /gallery': projectText('g'),
  'PUT /gallery/:shared/heart': { on: true },
  'PUT /classes/:class/gallery': { on: true },
  'PUT /classes/:class/gallery/:shared': { hidden: true },
  'PUT /me/question': { card: 'friendship', to: 'pupil-1' },
  'PUT /me/questions/:pupil': { answer: 'coming' },
  'POST /pair': projectText('t'),
  'PUT /pair/answer': { pair: 'pair-1', yes: true },
  'POST /pair/operations': {
    ops: [{ n: 1, base: 0, op: { kind: 'delete', program: 'main', block: 'b' } }],
  },
  'PUT /pair/hand': { program: 'main', at: 'b', x: 0.5, y: 0.5, chosen: null },
  'PUT /pair/role': { role: 'eye' },
  'POST /classes/:class/questionnaires': { form: 'after' },
  'POST /classes/:class/questionnaires/:form/paper': { bands: ['5-6'], n: 5, counts: {}, open: {} },
  'POST /me/questionnaire/token': { key: 'a'.repeat(32), blinded: 'b'.repeat(64) },
  'POST /classes/:class/questionnaires/:form/again': { pupil: 'pupil-1' },
  'POST /answers': { key: 'a'.repeat(32), id: 'b'.repeat(32), code: null, values: {} },
  'POST /answers/code': { key: 'a'.repeat(32), id: 'b'.repeat(32), code: 'owl-200' },
}

interface Scene {
  readonly class: string
  readonly pupil: string
  readonly shared: string
  readonly browser: Browser
}

/** Who asks, and which roles of the table that is. `refused`: what a refusal must be. */
const senders: {
  readonly [name: string]: { readonly roles: readonly Role[]; readonly refused: readonly number[] }
} = {
  nobody: { roles: [], refused: [401] },
  pupil: { roles: ['pupil'], refused: [401] },
  'pupil of another class': { roles: ['pupil'], refused: [401] },
  'pupil after 90 minutes': { roles: ['returning'], refused: [401] },
  'pupil of a closed class': { roles: ['returning'], refused: [401] },
  'removed pupil': { roles: [], refused: [401] },
  'pupil of an ended class': { roles: [], refused: [401, 410] },
  'teacher of the class': { roles: ['teacher', 'owner'], refused: [401, 403] },
  'teacher of another class': { roles: ['teacher'], refused: [401, 403, 404] },
  operator: { roles: ['teacher', 'operator'], refused: [401, 404] },
  'substitute of the class': { roles: ['substitute'], refused: [401] },
  'substitute of another class': { roles: [], refused: [401, 404] },
  'substitute after midnight': { roles: [], refused: [401] },
  'substitute who was sent home': { roles: [], refused: [401] },
  'teacher who signed out': { roles: [], refused: [401] },
}

const refusals = new Set(['signIn', 'join', 'showPictures', 'notYours', 'noSuchClass', 'classEnded'])

onBothDatabases((fresh) => {
  let server: Server
  let operator: Browser
  let owner: Browser
  let stranger: Browser

  beforeAll(async () => {
    const database = await fresh()
    server = new Server(database, quickAccounts(database))
    operator = await server.firstTeacher('the.operator')
    owner = await server.furtherTeacher(operator, 'the.owner')
    stranger = await server.furtherTeacher(operator, 'the.stranger')
  })

  /** A class with a pupil and a project, for one question: many of them delete something. */
  async function scene(): Promise<Scene> {
    const { id, code } = await server.openClass(owner)
    const pupil = await server.pupil(code, 'Fuchs')
    await pupil.browser.put('/projects/project-1?base=0&save=save-0001', projectText('a'))
    const { body } = await pupil.browser.post('/gallery?share=share-0001', projectText('g'))
    const { id: shared } = body as { id: string }
    return { class: id, pupil: pupil.id, shared, browser: pupil.browser }
  }

  async function substitute(name: string, asked: Scene): Promise<Browser> {
    const of = name.includes('another') ? (await scene()).class : asked.class
    const { token } = (await owner.post(`/classes/${of}/substitute`)).body as { token: string }
    const browser = server.browser()
    await browser.post('/substitute', { token })
    if (name.includes('midnight')) server.later(24 * 60)
    if (name.includes('home')) await owner.delete(`/classes/${of}/substitute`)
    return browser
  }

  async function browserOf(name: string, asked: Scene): Promise<Browser> {
    if (name === 'nobody') return server.browser()
    if (name === 'pupil') return asked.browser
    if (name === 'pupil of another class') return (await scene()).browser
    if (name === 'pupil after 90 minutes') server.later(91)
    if (name === 'pupil of a closed class') await owner.post(`/classes/${asked.class}/close`)
    if (name === 'removed pupil') await owner.delete(`/classes/${asked.class}/pupils/${asked.pupil}`)
    if (name === 'pupil of an ended class') await owner.delete(`/classes/${asked.class}`, { name: '5b' })
    if (/^(pupil|removed)/.test(name)) return asked.browser
    if (name === 'teacher of the class') return owner.twin()
    if (name === 'teacher of another class') return stranger.twin()
    if (name === 'operator') return operator.twin()
    if (name.startsWith('substitute')) return substitute(name, asked)
    const gone = stranger.twin()
    for (const cookie of gone.cookies.keys())
      if (cookie.startsWith('botgarten-teacher')) gone.cookies.set(cookie, 'x.y')
    return gone
  }

  const pathOf = ({ path }: Route, asked: Scene) =>
    path
      .replace(':class', asked.class)
      .replace(':teacher', 'no-such-teacher')
      .replace(':pupil', asked.pupil)
      .replace(':project', 'project-1')
      .replace(':revision', '1')
      .replace(':handout', 'handout-1')
      .replace(':shared', asked.shared)
      .replace(':form', 'after')
      .replace(/^(\/projects\/project-1)$/, '$1?base=1&save=save-0002')
      .replace(/^\/gallery$/, '/gallery?share=share-0002')

  // These end the sessions of the sender, who would be somebody else for the next route.
  const endsSessions = new Set(['/auth/sign-out', '/teachers/me/end-sessions', '/substitute/leave'])

  test.each(Object.entries(senders))(
    '%s is let through exactly where the table says so',
    async (name, { roles, refused }) => {
      let asked = await scene()
      let browser = await browserOf(name, asked)
      for (const route of routes) {
        if (endsSessions.has(route.path) && roles.length > 0) continue
        const key = `${route.method} ${route.path}`
        const { status, body } = await browser.ask(route.method, pathOf(route, asked), bodies[key])
        const code = (body as { error?: string } | null)?.error ?? ''
        const admitted = route.roles.some((role) => role === 'anyone' || roles.includes(role))
        const why = `${key} by ${name}: ${status} ${code}`
        expect(refusals.has(code), why).toBe(!admitted)
        if (!admitted) expect(refused, why).toContain(status)
        expect(status, why).toBeLessThan(500)
        // What was let through may have deleted what the next route is asked about; a refusal changes nothing.
        if (admitted && route.method !== 'GET' && roles.length > 0) {
          asked = await scene()
          browser = await browserOf(name, asked)
        }
      }
    },
  )

  test('no route of a class that has ended and is not deleted yet gives or takes anything, whoever asks', async () => {
    const asked = await scene()
    await owner.post(`/classes/${asked.class}/questionnaires`, { form: 'after' })
    const { key } = (await asked.browser.get('/me/questionnaire?tokens=1')).body as { key: string }
    const lent = await substitute('substitute of the class', asked)
    const { code } = (await owner.get(`/classes/${asked.class}`)).body as { code: string }
    const { token } = (await owner.post(`/classes/${asked.class}/substitute`)).body as { token: string }
    const { db } = server.ports.database
    await db
      .updateTable('class')
      .set({ endsOn: server.ports.day(0) })
      .where('id', '=', asked.class)
      .execute()

    const byRole = { pupil: asked.browser, returning: asked.browser, owner, substitute: lent }
    for (const role of ['pupil', 'returning', 'owner', 'substitute'] as const)
      for (const route of routes.filter(({ roles }) => roles.includes(role))) {
        const path = pathOf(route, asked)
        const answer = await byRole[role].ask(route.method, path, bodies[`${route.method} ${route.path}`])
        const why = `${route.method} ${route.path} as ${role}`
        expect(answer, why).toMatchObject({ status: 423, body: { error: 'classHidden' } })
      }

    const here = (await asked.browser.get('/state')).body
    expect(here).toMatchObject({ pupil: null, ended: false, hidden: true })
    expect((await lent.get('/state')).body).toMatchObject({ substitute: null })
    const device = server.browser()
    const pictures = ['boat', 'key', 'leaf']
    const sent = { '/look': {}, '/join': { nickname: 'Otter' }, '/return': { nickname: 'Otter', pictures } }
    for (const [path, body] of Object.entries(sent))
      expect((await device.post(path, { code, ...body })).body).toMatchObject({ error: 'noOpenClass' })
    expect((await device.post('/substitute', { token })).status).toBe(423)
    // Answers come without a cookie.
    const nobody = server.browser()
    const answer = { key, id: 'b'.repeat(32), code: null }
    expect((await nobody.get(`/answers/key?class=${asked.class}`)).status).toBe(423)
    expect((await nobody.post('/answers', { ...answer, values: {} })).status).toBe(423)
    expect((await nobody.post('/answers/code', { ...answer, code: 'owl-200' })).status).toBe(423)

    // The list of its teacher has its name without any content.
    const { classes } = (await owner.get('/classes')).body as { classes: { id: string }[] }
    expect(classes.find(({ id }) => id === asked.class)).toEqual({
      ...{ id: asked.class, name: '5b', language: 'en', grade: 5, endsOn: server.ports.day(0), hidden: true },
      ...{ code: '', words: [], open: false, joiningUntil: null, endsSoon: false, cards: null, level: null },
    })
  })

  test('what a pupil of another class saves under the same id is another project', async () => {
    const [one, other] = [await scene(), await scene()]
    await other.browser.put('/projects/project-1?base=1&save=save-0003', projectText('theirs'))
    const read = await one.browser.get('/projects/project-1')
    expect(read.body).toMatchObject({ revision: 1, project: { name: 'Garden a' } })
  })

  test('a pupil of one class cannot be reached through another class of the same teacher', async () => {
    const [one, other] = [await scene(), await scene()]
    for (const path of ['', '/projects', '/everything'])
      expect((await owner.get(`/classes/${one.class}/pupils/${other.pupil}${path}`)).status).not.toBe(200)
    expect((await owner.delete(`/classes/${one.class}/pupils/${other.pupil}`)).status).toBe(404)
  })

  test('a teacher who ended all sessions is signed out on every device', async () => {
    const teacher = await server.furtherTeacher(operator, 'the.careful')
    const laptop = teacher.twin()
    await teacher.post('/teachers/me/end-sessions')
    expect((await laptop.get('/classes')).status).toBe(401)
  })
})
