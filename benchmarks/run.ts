// `npm run bench [-- name …]`: every *.bench.ts here writes its table into results/.
import { readdirSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import type { Bench } from './bench.ts'
import { machine } from './machine.ts'
import { markdown } from './markdown.ts'

const ending = '.bench.ts'
const folder = import.meta.dirname
const all = readdirSync(folder)
  .filter((file) => file.endsWith(ending))
  .map((file) => file.slice(0, -ending.length))

async function make(name: string) {
  const bench = ((await import(join(folder, name + ending))) as { default: Bench }).default
  const made = {
    command: `npm run bench -- ${name}`,
    machine: machine(),
    date: new Date().toISOString().slice(0, 10),
  }
  const text = markdown(await bench(), made)
  writeFileSync(join(folder, 'results', `${name}.md`), text)
  console.log(text)
}

const wanted = process.argv.slice(2)
const unknown = wanted.filter((name) => !all.includes(name))
if (unknown.length > 0) {
  console.error(`No benchmark ${unknown.join(', ')}. There are: ${all.join(', ')}`)
  process.exitCode = 2
} else for (const name of wanted.length > 0 ? wanted : all) await make(name)
