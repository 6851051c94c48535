// `npm run bench [-- name …]`: every *.bench.ts here writes its table into results/.
import { spawnSync } from 'node:child_process'
import { existsSync, readdirSync, readFileSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import type { Bench } from './bench.ts'
import { machine } from './machine.ts'
import { markdown, writtenBelow } from './markdown.ts'

const ending = '.bench.ts'
const folder = import.meta.dirname
const all = readdirSync(folder)
  .filter((file) => file.endsWith(ending))
  .map((file) => file.slice(0, -ending.length))

async function make(name: string) {
  const bench = ((await import(join(folder, name + ending))) as { default: Bench }).default
  const table = await bench()
  const made = {
    command: `npm run bench -- ${name}`,
    machine: machine(),
    date: new Date().toISOString().slice(0, 10),
  }
  const file = join(folder, 'results', `${name}.md`)
  const text = markdown(table, made) + (existsSync(file) ? writtenBelow(readFileSync(file, 'utf8')) : '')
  writeFileSync(file, text)
  console.log(text)
}

/** Each in a process of its own: what one has loaded slows the shapes of objects that another measures. */
function makeEach(names: readonly string[]) {
  for (const name of names) {
    const { status } = spawnSync(process.execPath, [import.meta.filename, name], { stdio: 'inherit' })
    if (status !== 0) process.exitCode = 1
  }
}

const wanted = process.argv.slice(2)
const unknown = wanted.filter((name) => !all.includes(name))
if (unknown.length > 0) {
  console.error(`No benchmark ${unknown.join(', ')}. There are: ${all.join(', ')}`)
  process.exitCode = 2
} else if (wanted.length === 1) await make(wanted[0]!)
else makeEach(wanted.length > 0 ? wanted : all)
