// `npm run zips:try`: unpacks the zip for this Linux in a root without Node, starts it there and does what a teacher does
// with it. As root, since it makes such a root: `chroot` and `mount`.
import assert from 'node:assert/strict'
import { existsSync, mkdtempSync, readdirSync, readFileSync, renameSync, rmSync } from 'node:fs'
import { mkdir } from 'node:fs/promises'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { setTimeout as after } from 'node:timers/promises'
import { inHouse } from './prepare/house.mjs'
import { asScript, Trouble } from './prepare/run.mjs'
import { makeBareRoot, startInRoot } from './zips/bare-root.ts'
import { filesBelow } from './zips/contents.ts'
import { unpack } from './zips/unpack.ts'

const { version } = JSON.parse(readFileSync(inHouse('package.json'), 'utf8')) as { version: string }
const name = `botgarten-${version}-linux-${process.arch}`
const zip = inHouse('build', 'zips', `${name}.zip`)
const home = '/home/Jörg Groß'
const data = `${home}/.local/share/botgarten`
const port = 4199
const site = `http://localhost:${port}`

/** Says what holds, once it does. */
async function holds(sentence: string, work: () => Promise<void> | void) {
  await work()
  console.log(`✓ ${sentence}`)
}

async function untilItAnswers() {
  for (let tries = 0; tries < 300; tries++) {
    const answer = await fetch(site).catch(() => null)
    if (answer?.ok) return
    await after(100)
  }
  throw new Trouble('The lab did not answer within half a minute.')
}

const statusOf = async (path: string) => (await fetch(site + path)).status
const stateOf = async () =>
  (await (await fetch(`${site}/api/class/state`)).json()) as { firstTeacher: { name: string } | null }

async function makeTeacher(token: string) {
  const body = JSON.stringify({ token, username: 'm.weber', password: 'kastanie im regen' })
  const headers = { 'content-type': 'application/json', origin: site }
  return (await fetch(`${site}/api/class/teachers`, { method: 'POST', headers, body })).status
}

async function tryIn(root: string) {
  const [downloads, replaced] = [join(root, home, 'Downloads'), join(root, home, 'Neues Botgarten')]
  await mkdir(downloads, { recursive: true })
  unpack(zip, downloads)
  const unpacked = join(downloads, name)
  const files = filesBelow(unpacked).length
  makeBareRoot(root, [join(unpacked, 'node', 'node')])
  const start = (folder: string, args: readonly string[]) =>
    startInRoot(root, `${folder.slice(root.length)}/botgarten.sh`, args, home)
  const serving = ['serve', '--port', String(port), '--lang', 'en']

  const first = start(unpacked, serving)
  await holds('it starts where there is no Node, in a folder with blanks and umlauts', untilItAnswers)
  await holds('pages, cards and what there is not are answered', async () => {
    for (const path of ['/', '/lab/free', '/lab/friendship', '/teacher/start', '/zoo'])
      assert.equal(await statusOf(path), 200, path)
    assert.equal(await statusOf('/lab/unknown'), 404)
  })
  await holds('its data lie outside of its folder', () => {
    assert.ok(existsSync(join(root, data, 'botgarten.db')))
    assert.equal(filesBelow(unpacked).length, files)
  })
  await holds('the link in the data folder makes the first teacher', async () => {
    const token = readFileSync(join(root, data, 'first-teacher.txt'), 'utf8')
      .trim()
      .split('#')[1]!
    assert.equal(await makeTeacher(token), 204)
  })
  await holds('a second start says that one is running, and harms nothing', async () => {
    const second = start(unpacked, serving)
    assert.equal(await second.ended, 1)
    assert.match(second.output(), /running on .* already/)
  })
  await holds('closing the window stops it', async () => {
    first.process.kill('SIGHUP')
    assert.equal(await Promise.race([first.ended, after(10_000, 'still running')]), 0)
  })
  renameSync(unpacked, replaced)
  const next = start(replaced, serving)
  await holds('the data are there in a folder that replaces the first', async () => {
    await untilItAnswers()
    assert.equal((await stateOf()).firstTeacher?.name, 'm.weber')
    next.process.kill('SIGTERM')
    assert.equal(await next.ended, 0)
  })
  await holds('35 pupils rehearse, and none of their saves is lost', async () => {
    const rehearsal = start(replaced, ['serve', '--rehearse', '35', '--seconds', '20', '--lang', 'en'])
    await rehearsal.ended
    console.log(`  ${rehearsal.output().trim()}`)
    assert.match(rehearsal.output(), / 0 lost/)
  })
  await holds('a folder that was not unpacked to its end says so', async () => {
    rmSync(join(replaced, 'app', 'complete'))
    const broken = start(replaced, serving)
    assert.equal(await broken.ended, 1)
    assert.match(broken.output(), /not complete/)
  })
  assert.deepEqual(readdirSync(join(root, home)).toSorted(), ['.local', 'Downloads', 'Neues Botgarten'])
}

await asScript(async () => {
  if (process.getuid?.() !== 0) throw new Trouble('A root of its own can only be made by root.')
  if (!existsSync(zip)) throw new Trouble(`${zip} is missing: npm run zips -- linux-${process.arch}`)
  const root = mkdtempSync(join(tmpdir(), 'botgarten-bare-'))
  try {
    await tryIn(root)
  } finally {
    rmSync(root, { recursive: true, force: true })
  }
  return 0
})
