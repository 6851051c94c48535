// `npm run image`: the lab as an image for a Raspberry Pi's card, and the file that updates one. From Debian's packages; as
// root, since files of the image belong to root. `-- --quick` leaves out what only a download needs: the packed image;
// `-- --same-debian` takes the tree of packages that the last time made.
import { execFileSync } from 'node:child_process'
import { createHash } from 'node:crypto'
import { createReadStream, mkdirSync, statSync, writeFileSync } from 'node:fs'
import { basename, join } from 'node:path'
import root from '../package.json' with { type: 'json' }
import { bootImage, cardImage, dataImage, rootImage, systemFiles, updateFile } from './image/fill.ts'
import { missing, toBuild, toEmulate } from './image/tools.ts'
import { addLab, finishTree, letKernelEmulate, makeTree } from './image/tree.ts'
import { buildWhenNeeded } from './prepare/build.mjs'
import { house, inHouse } from './prepare/house.mjs'
import { asScript, Trouble } from './prepare/run.mjs'
import { contentsFor } from './zips/contents.ts'
import { installNodes } from './zips/nodes.ts'
import { systems } from './zips/systems.ts'

const target = inHouse('build', 'image')
const work = join(target, 'work')
const name = join(target, `botgarten-pi-${root.version}`)
const began = Date.now()

function step(sentence: string) {
  console.log(`${String(Math.round((Date.now() - began) / 1000)).padStart(5)} s  ${sentence}`)
}

async function sumOf(file: string): Promise<string> {
  const hash = createHash('sha256')
  for await (const part of createReadStream(file)) hash.update(part as Buffer)
  return `${hash.digest('hex')}  ${basename(file)}\n`
}

function refuse() {
  const tools = process.arch === 'arm64' ? toBuild : [...toBuild, toEmulate]
  const lacking = missing(tools)
  if (lacking !== null) throw new Trouble(lacking)
  if (process.getuid?.() !== 0) throw new Trouble('Files of the image belong to root: only root can make it.')
}

/** All packages of the image, with their versions. */
const listPackages = (tree: string) =>
  execFileSync('dpkg-query', [
    `--admindir=${tree}/var/lib/dpkg`,
    '-W',
    '-f=${Package} ${Version} ${Architecture}\n',
  ])

const has = (option: string) => process.argv.includes(option)

await asScript(async () => {
  refuse()
  const quick = has('--quick')
  await buildWhenNeeded()
  const nodes = await installNodes()
  mkdirSync(work, { recursive: true })
  const [tree, system] = [join(work, 'tree'), join(work, 'system')]
  letKernelEmulate()
  if (!has('--same-debian')) {
    step('Debian for arm64 …')
    makeTree(tree, join(work, 'overlay'), inHouse('build', 'image-packages'))
  }
  finishTree(tree)
  const arm = systems.find(({ id }) => id === 'linux-arm64')!
  addLab(tree, contentsFor(arm, house, nodes))
  step('Partitions …')
  systemFiles(tree, system)
  const images = {
    boot: bootImage(tree, system, work),
    a: rootImage(tree, work),
    data: dataImage(tree, work),
  }
  cardImage(`${name}.img`, images)
  writeFileSync(`${name}-packages.txt`, listPackages(tree))
  step('Update …')
  updateFile(`${name}.update`, images.a, system, work)
  if (!quick) {
    step('Packing …')
    execFileSync('xz', ['-T0', '-2', '-k', '-f', `${name}.img`])
  }
  const files = [`${name}${quick ? '.img' : '.img.xz'}`, `${name}.update`, `${name}-packages.txt`]
  writeFileSync(join(target, 'SHA256SUMS'), (await Promise.all(files.map(sumOf))).join(''))
  for (const file of [`${name}.img`, ...files])
    console.log(`${basename(file)}  ${(statSync(file).size / 1e6).toFixed(1)} MB`)
  step(`They lie in ${target}, their checksums in SHA256SUMS.`)
  return 0
})
