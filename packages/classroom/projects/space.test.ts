import fc from 'fast-check'
import { beforeAll, beforeEach, expect, test } from 'vitest'
import type { Database } from '../database/database.ts'
import type { Browser } from '../testing/browser.ts'
import { onBothDatabases } from '../testing/databases.ts'
import { projectText } from '../testing/projects.ts'
import { quickAccounts, Server } from '../testing/world.ts'
import { saveQueueOn } from './save-queue.ts'
import { recount, type Space } from './space-store.ts'

/** Pictures of 12, 16 and 20 letters. */
const pictures = ['iVBORw0KGgo=', 'iVBORw0KGgoAAAA=', 'iVBORw0KGgoAAAAAAAA=']
const withPicture = (mark: string, at: number) =>
  projectText(mark, { ['b'.repeat(64)]: { type: 'image/png', base64: pictures[at % 3] } })

onBothDatabases((fresh) => {
  let database: Database
  let server: Server
  let teacher: Browser
  let classId: string
  let fox: Awaited<ReturnType<Server['pupil']>>
  let owl: Awaited<ReturnType<Server['pupil']>>
  let saves = 0

  beforeAll(async () => {
    database = await fresh()
    server = new Server(database, quickAccounts(database))
    teacher = await server.firstTeacher()
  })
  beforeEach(async () => {
    const { id, code } = await server.openClass(teacher)
    classId = id
    fox = await server.pupil(code, 'Fuchs')
    owl = await server.pupil(code, 'Eule')
  })

  const save = (browser: Browser, base: number, text: string, project = 'project-1') =>
    browser.put(`/projects/${project}?base=${base}&save=save-${1000 + ++saves}`, text)

  async function spaceOf(pupil: string): Promise<Space> {
    const row = await database.db
      .selectFrom('pupil')
      .innerJoin('class', 'class.id', 'pupil.class')
      .select(['pupil.space as pupil', 'class.space as class'])
      .where('pupil.id', '=', pupil)
      .executeTakeFirstOrThrow()
    return { pupil: row.pupil, class: row.class }
  }

  const versionsOf = async (browser: Browser, project = 'project-1') => {
    const { body } = await browser.get(`/projects/${project}/versions`)
    return (body as { versions: { revision: number }[] }).versions.map(({ revision }) => revision)
  }

  /** The same children on a server with other limits, bytes. */
  function small(most: Space) {
    const other = new Server(database, { ...quickAccounts(database), save: saveQueueOn(database, most) })
    other.now = server.now
    const browserOf = ({ browser }: typeof fox) => {
      const same = other.browser()
      for (const [name, value] of browser.cookies) same.cookies.set(name, value)
      return same
    }
    return { fox: browserOf(fox), owl: browserOf(owl) }
  }

  /** Bytes of a version of these tests: all marks have one letter. */
  async function sizeOfVersion() {
    await save(owl.browser, 0, projectText('0'))
    return (await spaceOf(owl.id)).pupil
  }

  test('a pupil has 50 MB at most: the own old versions go for new work, then it is refused with a reason', async () => {
    const size = await sizeOfVersion()
    const child = small({ class: 1e9, pupil: 3 * size }).fox
    for (let at = 0; at < 5; at++) expect((await save(child, at, projectText(`${at}`))).status).toBe(200)
    expect(await versionsOf(child)).toEqual([5, 4, 3])
    expect((await save(child, 0, projectText('5'), 'project-2')).status).toBe(200)
    expect(await versionsOf(child)).toEqual([5, 4])
    expect((await save(child, 0, projectText('6'), 'project-3')).status).toBe(200)
    // Three projects, none with an old version.
    expect(await save(child, 0, projectText('7'), 'project-4')).toMatchObject({
      status: 422,
      body: { error: 'projectRefused', reason: 'pupilFull', most: 50_000_000 },
    })
    expect((await save(child, 5, projectText('8'))).status).toBe(200)
    expect((await child.delete('/projects/project-2?base=1')).status).toBe(200)
    expect((await save(child, 0, projectText('7'), 'project-4')).status).toBe(200)
    expect((await spaceOf(fox.id)).pupil).toBe(3 * size)
  })

  test('in a full class a pupil who takes more space takes nothing from one who takes less', async () => {
    const size = await sizeOfVersion()
    await save(owl.browser, 1, projectText('1'))
    for (let at = 0; at < 4; at++) await save(fox.browser, at, projectText(`${at}`))
    // Six versions fill it: two of the owl, four of the fox.
    const { fox: child } = small({ class: 6 * size, pupil: 1e9 })
    for (let at = 4; at < 8; at++) expect((await save(child, at, projectText(`${at}`))).status).toBe(200)
    for (const project of ['project-2', 'project-3', 'project-4'])
      expect((await save(child, 0, projectText('a'), project)).status).toBe(200)
    expect(await save(child, 0, projectText('b'), 'project-5')).toMatchObject({
      status: 507,
      body: { error: 'classFull' },
    })
    expect(await versionsOf(owl.browser)).toEqual([2, 1])
  })

  test('in a full class old versions of one who takes more space go for the work of one who takes less', async () => {
    const size = await sizeOfVersion()
    for (let at = 0; at < 5; at++) await save(fox.browser, at, projectText(`${at}`))
    const { owl: child } = small({ class: 6 * size, pupil: 1e9 })
    expect((await save(child, 0, projectText('a'), 'project-2')).status).toBe(200)
    expect(await versionsOf(fox.browser)).toEqual([5, 4, 3, 2])
    expect((await save(child, 1, projectText('b'), 'project-2')).status).toBe(200)
    // The own old version went.
    expect(await versionsOf(child, 'project-2')).toEqual([2])
    expect(await versionsOf(fox.browser)).toEqual([5, 4, 3, 2])
  })

  test('a save without room takes those that wait with it not along', async () => {
    const size = await sizeOfVersion()
    const { fox: child, owl: other } = small({ class: 1e9, pupil: size })
    await save(child, 0, projectText('a'))
    const both = await Promise.all([
      save(child, 0, projectText('b'), 'project-2'),
      save(other, 1, projectText('c')),
      save(child, 0, projectText('d'), 'project-3'),
    ])
    expect(both.map(({ status }) => status)).toEqual([422, 200, 422])
  })

  test('a picture counts once a class and once a pupil, and is deleted with the last version that shows it', async () => {
    const size = await sizeOfVersion()
    const before = await spaceOf(fox.id)
    await save(fox.browser, 0, withPicture('a', 0))
    await save(fox.browser, 1, withPicture('b', 0))
    await save(owl.browser, 1, withPicture('c', 0))
    expect(await spaceOf(fox.id)).toEqual({ pupil: 2 * size + 12, class: before.class + 3 * size + 12 })
    expect((await spaceOf(owl.id)).pupil).toBe(2 * size + 12)
    await fox.browser.delete('/projects/project-1?base=2')
    expect(await spaceOf(fox.id)).toEqual({ pupil: 0, class: before.class + size + 12 })
    await owl.browser.delete('/projects/project-1?base=2')
    expect(await spaceOf(owl.id)).toEqual({ pupil: 0, class: 0 })
    const left = await database.db.selectFrom('asset').selectAll().where('class', '=', classId).execute()
    expect(left).toEqual([])
  })

  const change = fc.record({
    kind: fc.constantFrom('save', 'save', 'save', 'delete', 'share', 'takeOut'),
    child: fc.nat(1),
    project: fc.nat(1),
    picture: fc.option(fc.nat(2)),
  })

  test('property: bytes counted with each change equal those of the stored rows', async () => {
    await fc.assert(
      fc.asyncProperty(fc.array(change, { minLength: 5, maxLength: 25 }), async (changes) => {
        const { code } = await server.openClass(teacher)
        const children = [await server.pupil(code, 'Luchs'), await server.pupil(code, 'Igel')]
        const revisions = new Map<string, number>()
        const shared: string[][] = [[], []]
        for (const [at, { kind, child, project, picture }] of changes.entries()) {
          const { browser } = children[child]!
          const id = `project-${project}`
          const base = revisions.get(`${child} ${id}`) ?? 0
          const text = picture === null ? projectText(`${at}`) : withPicture(`${at}`, picture)
          if (kind === 'save') {
            const { body } = await save(browser, base, text, id)
            revisions.set(`${child} ${id}`, (body as { revision: number }).revision)
          } else if (kind === 'delete') {
            await browser.delete(`/projects/${id}?base=${base}`)
            revisions.delete(`${child} ${id}`)
          } else if (kind === 'share') {
            const { body } = await browser.post(`/gallery?share=share-${1000 + ++saves}`, text)
            shared[child]!.push((body as { id: string }).id)
          } else await browser.delete(`/gallery/${shared[child]!.pop() ?? 'none'}`)
        }
        const counted = [await spaceOf(children[0]!.id), await spaceOf(children[1]!.id)]
        await recount(database.db, children[0]!.class)
        expect([await spaceOf(children[0]!.id), await spaceOf(children[1]!.id)]).toEqual(counted)
      }),
      { numRuns: 12 },
    )
  })
})
