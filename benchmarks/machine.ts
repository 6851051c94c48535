import { spawnSync } from 'node:child_process'
import { cpus, totalmem } from 'node:os'
import { findChromium } from '../e2e/chromium.mjs'

function chromiumVersion() {
  const path = findChromium()
  const said = path === null ? '' : spawnSync(path, ['--version'], { encoding: 'utf8' }).stdout
  return /[\d.]{5,}/.exec(said ?? '')?.[0] ?? 'none'
}

/** One line that names the machine and what ran on it. */
export function machine(): string {
  const [cpu] = cpus()
  const memory = Math.round(totalmem() / 2 ** 30)
  return [
    `${cpu?.model.trim() ?? 'unknown processor'}, ${cpus().length} cores, ${memory} GB`,
    `${process.platform} ${process.arch}`,
    `Node ${process.versions.node}`,
    `Chromium ${chromiumVersion()}`,
  ].join(' · ')
}
