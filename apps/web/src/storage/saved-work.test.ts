import { execFile } from 'node:child_process'
import { globSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { promisify } from 'node:util'
import { content } from '@botgarten/content/files'
import { courseOf, learningKey } from '@botgarten/maps'
import { learningIn, parseProject, parseScene, writeProject, type Project } from '@botgarten/programs'
import { parseBrainFile } from '@botgarten/programs/brain-file'
import { afterAll, beforeAll, describe, expect, test } from 'vitest'
import { read as readSorting, written } from '#features/sorting/model/kept.ts'
import { listBin } from './bin.ts'
import { readHome } from './home-file.ts'
import { settingNames, settingsIn } from './home-settings.ts'
import { readLink } from './link.ts'
import { list, load } from './projects.ts'
import { putDevice, type Device } from './testing/device.ts'

// What children's devices and files hold, as products of the past have written it (e2e/saved-work.ts): all of it opens,
// runs as it ran then, and knows what it had learned.

const house = new URL('../../../../', import.meta.url)
const folders = globSync('saved-*', { cwd: new URL('testing/', import.meta.url) })

interface Expected {
  readonly [id: string]: { readonly hash: string; readonly q?: readonly number[] }
}

const scratch = mkdtempSync(join(tmpdir(), 'botgarten-saved-'))
afterAll(() => rmSync(scratch, { recursive: true }))

/** What `botgarten run` says of each project, in one process: the hash of its first 20 seconds. */
async function hashesOf(projects: ReadonlyMap<string, Project>): Promise<{ readonly [id: string]: string }> {
  const paths = [...projects].map(([id, project]) => {
    const path = join(scratch, `${id}.json`)
    writeFileSync(path, writeProject(project))
    return path
  })
  const calls = `
    import { call } from ${JSON.stringify(new URL('apps/cli/call.ts', house).href)}
    const hashes = []
    for (const path of process.argv.slice(1)) {
      const { stdout } = await call(['run', path, '--seconds', '20', '--seed', '7', '--json'])
      hashes.push(JSON.parse(stdout).hash)
    }
    console.log(JSON.stringify(hashes))`
  const { stdout } = await promisify(execFile)(process.execPath, [
    '--input-type=module',
    '--eval',
    calls,
    ...paths,
  ])
  const hashes = JSON.parse(stdout) as readonly string[]
  return Object.fromEntries([...projects.keys()].map((id, at) => [id, hashes[at]!]))
}

/** The Q-values that a project's program has learned, by its own seed and moves. */
function learnedIn({ programs, q }: Project): readonly number[] | undefined {
  const [[id, learned] = []] = Object.entries(q ?? {})
  const outline = id === undefined ? null : learningIn(programs[id]!)
  if (!outline || !learned) return undefined
  // Else the playground would begin again.
  expect(learned.key).toBe(learningKey(outline))
  const map = content.mapFile(outline.map)
  const course = courseOf(outline, map!, learned.seed)
  course.advance(learned.moves)
  return [...course.learner.q]
}

describe.each(folders)('%s', (folder) => {
  const text = (path: string) => readFileSync(new URL(`testing/${folder}/${path}`, import.meta.url), 'utf8')
  const device = JSON.parse(text('device.json')) as Device
  const expected = JSON.parse(text('expected.json')) as Expected
  const saved = [...device.stores.projects, ...device.stores.bin]
  let hashes: Awaited<ReturnType<typeof hashesOf>>
  beforeAll(async () => {
    hashes = await hashesOf(new Map(saved.map(({ id, project }) => [id, parseProject(project)])))
  }, 60_000)
  const named = (name: string) => saved.find(({ project }) => project.name === name)!
  const shown: { readonly [name: string]: string } = {
    ...{ Freundschaft: 'friendship', Angst: 'fear', Eisenbahn: 'railway', Waldlabyrinth: 'forest' },
    'Freies Labor': 'free',
  }
  /** As the shelf hands it out: under the name that it bears there. */
  const underName = ({ name, ...project }: Project): Project => ({ name: shown[name] ?? name, ...project })

  test('every record of the device opens as it was written', async () => {
    await putDevice(device)
    const { projects, damaged } = await list()
    expect(damaged).toEqual([])
    expect(projects.map(({ id }) => id).toSorted()).toEqual(
      device.stores.projects.map(({ id }) => id).toSorted(),
    )
    // The second time from records that have been split.
    for (const one of [...device.stores.projects, ...device.stores.projects])
      expect(await load(one.id)).toEqual(one)
    const bin = await listBin()
    expect(bin.damaged).toEqual([])
    expect(bin.thrown.map(({ id, was, project }) => ({ id, was, project }))).toEqual(
      device.stores.bin
        .toSorted((a, b) => b.thrown - a.thrown)
        .map(({ id, was, project }) => ({ id, was, project })),
    )
  })

  test('every setting of the device is one', () => {
    const texts = device.localStorage
    const settings = settingsIn({ get: (name) => texts[`botgarten.${name}`] ?? null, put: () => {} })
    const names = settingNames.filter((name) => `botgarten.${name}` in texts)
    expect(Object.keys(settings).toSorted()).toEqual(names.toSorted())
    for (const name of names.filter((one) => one !== 'language'))
      expect(settings[name]).toEqual(JSON.parse(texts[`botgarten.${name}`]!))
    expect(names.length).toBeGreaterThanOrEqual(8)
  })

  test.each(saved.map(({ id, project }) => [id, project] as const))(
    '%s runs as it ran, and knows what it had learned',
    (id, data) => {
      const project = parseProject(data)
      expect(project).toEqual(data)
      expect(learnedIn(project)).toEqual(expected[id]!.q)
      if (project.sorting) expect(written(readSorting(project.sorting)!)).toEqual(project.sorting)
      expect(hashes[id]).toBe(expected[id]!.hash)
    },
  )

  test('every project file is the project that it was saved from', () => {
    const files = globSync('files/*.json', { cwd: new URL(`testing/${folder}/`, import.meta.url) })
    expect(files).toHaveLength(device.stores.projects.length)
    for (const file of files) {
      const project = underName(parseProject(text(file)))
      expect(project).toEqual(named(project.name).project)
    }
  })

  test('the home file holds all of it', () => {
    const { projects, bin, settings, broken } = readHome(JSON.parse(text('home.botgarten.json')))
    expect(broken).toBe(0)
    expect(projects).toEqual(
      device.stores.projects
        .toSorted((a, b) => b.changed - a.changed)
        .map(({ id, changed, project }) => ({ id, changed, project })),
    )
    expect(bin.map(({ project }) => project).toSorted(byName)).toEqual(
      device.stores.bin.map(({ project }) => project).toSorted(byName),
    )
    expect(Object.keys(settings).length).toBeGreaterThanOrEqual(8)
  })

  test('every link is the project that it was made of, without its progress', () => {
    const links = Object.entries(JSON.parse(text('links.json')) as { [name: string]: string })
    expect(links.length).toBeGreaterThanOrEqual(6)
    for (const [, hash] of links) {
      const project = underName(readLink(hash))
      const { progress: _, ...rest } = named(project.name).project
      expect(project).toEqual(rest)
    }
  })

  test('a world and a brain that were saved as files open', () => {
    const { world, assets } = named('free').project
    const { robots: _, ...scene } = world
    expect(parseScene(text('scene.json'))).toMatchObject({ ...scene, assets })
    const brain = parseBrainFile(text('brain.brain.json'))
    expect(brain.name).toBe('mild')
    // Weights of 0 are left out of its file.
    expect(named('fear').project.brains['net']!.sets['mild']).toMatchObject(brain.weights)
  })
})

const byName = (a: Project, b: Project) => (a.name < b.name ? -1 : 1)
