import { spawn, spawnSync } from 'node:child_process'
import { closeSync, mkdtempSync, openSync, readFileSync, rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { house } from './house.mjs'

/** A sentence for the person at the keyboard, without a stack. */
export class Trouble extends Error {
  /** @param {string} message @param {number} [code] exit code of the script */
  constructor(message, code = 1) {
    super(message)
    this.code = code
  }
}

/**
 * Runs a program to its end with our own terminal.
 * @param {string} program
 * @param {readonly string[]} args
 * @param {import('node:child_process').SpawnOptions} [options]
 * @returns {Promise<number>} its exit code; 127 where it could not be started
 */
export function run(program, args, options = {}) {
  return new Promise((done) => {
    const child = spawn(program, args, { cwd: house, stdio: 'inherit', ...options })
    child.once('error', () => done(127))
    child.once('exit', (code, signal) => done(code ?? (signal === null ? 1 : 128)))
  })
}

/**
 * Runs a program to its end and shows what it said only when it fails.
 * @param {string} program
 * @param {readonly string[]} args
 * @param {import('node:child_process').SpawnSyncOptions} [options]
 * @returns {number} its exit code
 */
export function runQuietly(program, args, options = {}) {
  const { status, stdout, stderr, error } = spawnSync(program, args, { cwd: house, ...options })
  if (status !== 0) console.error(`${stdout}${stderr}${error ?? ''}`)
  return status ?? 1
}

/**
 * Runs npm on the Node that npm itself came with: the one brought along may be replaced by what npm does.
 * @param {readonly string[]} args
 * @param {import('node:child_process').SpawnOptions} [options]
 */
export function npm(args, options = {}) {
  const { npm_execpath: script, npm_node_execpath: node } = process.env
  if (script?.endsWith('.js')) return run(node ?? process.execPath, [script, ...args], options)
  return process.platform === 'win32'
    ? run('npm.cmd', args, { shell: true, ...options })
    : run('npm', args, options)
}

/**
 * The same, but it says nothing on our terminal.
 * @param {readonly string[]} args
 * @param {import('node:child_process').SpawnOptions} [options]
 * @returns {Promise<{ code: number, said: string }>} its exit code and what it said
 */
export async function npmAside(args, options = {}) {
  const folder = mkdtempSync(join(tmpdir(), 'botgarten-said-'))
  const file = join(folder, 'said')
  const out = openSync(file, 'w')
  try {
    const code = await npm(args, { ...options, stdio: ['ignore', out, out] })
    return { code, said: readFileSync(file, 'utf8') }
  } finally {
    closeSync(out)
    rmSync(folder, { recursive: true, force: true })
  }
}

/**
 * Runs `work` as the whole of a script: a `Trouble` is one line on standard error and an exit with its code.
 * @param {() => Promise<number>} work gives the exit code
 */
export async function asScript(work) {
  try {
    process.exitCode = await work()
  } catch (error) {
    if (!(error instanceof Trouble)) throw error
    console.error(error.message)
    process.exitCode = error.code
  }
}
