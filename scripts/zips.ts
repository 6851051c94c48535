// `npm run zips`: the lab with its own Node and database, a zip for each system, from npm packages alone.
// `npm run zips -- linux-x64` makes that one.
import { createHash } from 'node:crypto'
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { buildWhenNeeded } from './prepare/build.mjs'
import { house, inHouse } from './prepare/house.mjs'
import { asScript, Trouble } from './prepare/run.mjs'
import { writeZip, type Entry } from './zips/archive.ts'
import { machineOf } from './zips/binaries.ts'
import { contentsFor } from './zips/contents.ts'
import { installNodes } from './zips/nodes.ts'
import { systems, type System } from './zips/systems.ts'

const { version } = JSON.parse(readFileSync(inHouse('package.json'), 'utf8')) as { version: string }
const target = inHouse('build', 'zips')
/** Of all files: the same sources give the same bytes, whoever makes the zip. Zips know no time before 1980. */
const date = new Date(2026, 0, 1)

function refuseOtherMachines({ id }: System, entries: readonly Entry[]) {
  for (const { path, read } of entries) {
    if (!/\.node$|^node\/node/.test(path)) continue
    const made = machineOf(read())
    if (made !== id)
      throw new Trouble(`${path} of the zip for ${id} is made for ${made ?? 'something else'}.`)
  }
}

/** @returns the line of the zip in the list of checksums */
function make(system: System, nodes: string): string {
  const name = `botgarten-${version}-${system.id}`
  const entries = contentsFor(system, house, nodes)
  refuseOtherMachines(system, entries)
  const file = join(target, `${name}.zip`)
  writeZip(
    file,
    entries.map((entry) => ({ ...entry, path: `${name}/${entry.path}` })),
    date,
  )
  const zip = readFileSync(file)
  console.log(`${name}.zip  ${(zip.length / 1e6).toFixed(1)} MB  ${entries.length} files`)
  return `${createHash('sha256').update(zip).digest('hex')}  ${name}.zip\n`
}

await asScript(async () => {
  const wanted = process.argv.slice(2)
  const unknown = wanted.find((id) => !systems.some((system) => system.id === id))
  if (unknown !== undefined)
    throw new Trouble(`There is no zip for ${unknown}, only for ${systems.map(({ id }) => id).join(', ')}.`)
  await buildWhenNeeded()
  const nodes = await installNodes()
  mkdirSync(target, { recursive: true })
  const chosen = systems.filter(({ id }) => wanted.length === 0 || wanted.includes(id))
  const sums = chosen.map((system) => make(system, nodes))
  writeFileSync(join(target, 'SHA256SUMS'), sums.join(''))
  console.log(`\nThey lie in ${target}, their checksums in SHA256SUMS (sha256sum --check SHA256SUMS).`)
  return 0
})
