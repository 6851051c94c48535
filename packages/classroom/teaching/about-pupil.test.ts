import { beforeAll, expect, test } from 'vitest'
import { ask } from '../asking/peers-store.ts'
import type { Browser } from '../testing/browser.ts'
import { onBothDatabases } from '../testing/databases.ts'
import { projectText } from '../testing/projects.ts'
import { Server } from '../testing/world.ts'
import { noteResult } from './results-store.ts'

const photo = { type: 'image/png', base64: 'iVBORw0KGgo=' }
const withPhoto = (name: string) => projectText(name, { ['b'.repeat(64)]: photo })

/** Tables with a column for a pupil, and the part of the file that has them. */
const partOf: { readonly [table: string]: string } = {
  heart: 'hearts',
  handoutTo: 'sent',
  peerQuestion: 'asked',
  project: 'projects',
  result: 'results',
  shared: 'shared',
  thrown: 'bin',
  token: 'questionnaires',
  version: 'versions',
  versionAsset: 'versions',
}
/** Tables without content of a child. */
const technical: { readonly [table: string]: string } = {
  answered: 'which save became which revision, for a save that is sent twice',
  mark: 'a random token for each change, to notice a restore',
  pupilSession: 'hashes of the tokens of signed-in devices',
}

onBothDatabases((fresh) => {
  let server: Server
  let teacher: Browser
  let at: string
  let fox: Awaited<ReturnType<Server['pupil']>>

  beforeAll(async () => {
    server = new Server(await fresh())
    teacher = await server.firstTeacher()
    const { id, code } = await server.openClass(teacher)
    fox = await server.pupil(code, 'Füchschen 7')
    at = `/classes/${id}/pupils/${fox.id}/everything`
    const owl = await server.pupil(code, 'Eule')
    const { browser } = fox
    for (const [base, name] of ['one', 'two', 'three'].entries())
      await browser.put(`/projects/project-1?base=${base}&save=save-on-${base}`, withPhoto(name))
    await browser.put('/projects/project-2?base=0&save=save-of-2', projectText('gone'))
    await browser.delete('/projects/project-2?base=1')
    const passed = { class: id, card: 'friendship' }
    await noteResult(server.ports.database.db, { ...passed, pupil: fox.id, done: 2 })
    await noteResult(server.ports.database.db, { ...passed, pupil: owl.id, done: 3 })
    await browser.post('/gallery?share=share-0001', withPhoto('shared'))
    await teacher.post(`/classes/${id}/handouts`, {
      to: [fox.id],
      kind: 'hint',
      text: 'Look at the left eye.',
    })
    await ask(server.ports.database.db, {
      ...passed,
      pupil: fox.id,
      to: owl.id,
      at: server.now,
      answer: null,
    })
  })

  const everything = async () => JSON.parse((await teacher.get(at)).body as string) as object

  test('the data of a pupil include earlier versions, the bin, results, hints and pictures', async () => {
    const all = await everything()
    expect(all).toMatchObject({
      ...{ nickname: 'Füchschen 7', bin: ['project-2'], results: [{ card: 'friendship', done: 2 }] },
      ...{ sent: [{ kind: 'hint', text: 'Look at the left eye.', project: null }] },
      ...{ asked: { to: 'Eule', card: 'friendship' } },
      shared: [{ title: 'Garden shared', project: { assets: { ['b'.repeat(64)]: photo } } }],
    })
    const { projects, versions } = all as {
      projects: { id: string; revision: number }[]
      versions: { id: string; revision: number; project: { name: string; assets: object } }[]
    }
    expect(projects.map(({ id, revision }) => [id, revision])).toEqual([['project-1', 3]])
    expect(versions.map(({ id, project }) => `${id} ${project.name}`)).toEqual([
      ...['project-1 Garden three', 'project-1 Garden two', 'project-1 Garden one'],
    ])
    expect(versions[0]!.project.assets).toEqual({ ['b'.repeat(64)]: photo })
  })

  test('each table with a column for a pupil is in the file, or on the list of technical ones', async () => {
    const { db } = server.ports.database
    const tables = await db.introspection.getTables()
    const found = tables
      .filter(({ columns }) => columns.some(({ name }) => name === 'pupil'))
      .map(({ name }) => name)
    expect(found.toSorted()).toEqual([...Object.keys(partOf), ...Object.keys(technical)].toSorted())
    const all = await everything()
    for (const part of Object.values(partOf)) expect(all).toHaveProperty(part)
  })

  test('the file is sent in pieces, a version each, with the nickname in its name', async () => {
    const answer = await teacher.open(at)
    expect(answer.headers.get('content-disposition')).toBe(
      "attachment; filename*=UTF-8''botgarten-F%C3%BCchschen%207.json",
    )
    let pieces = 0
    for await (const _ of answer.body!) pieces++
    expect(pieces).toBeGreaterThan(5)
  })
})
