import { execFileSync } from 'node:child_process'
import { cpSync, existsSync, mkdirSync, mkdtempSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { dirname, join } from 'node:path'

const generated = ['apps/web/.svelte-kit', 'apps/web/src/words/generated', 'apps/web/project.inlang']
const modules = ['node_modules', 'apps/web/node_modules', 'apps/cli/node_modules']

/** A copy of the tree as it is now, in which anything may be changed. Packages from elsewhere are linked, not copied. */
export function copyTree(from: string): string {
  const to = mkdtempSync(join(tmpdir(), 'botgarten-mutants-'))
  const files = execFileSync('git', ['ls-files', '-co', '--exclude-standard'], {
    cwd: from,
    encoding: 'utf8',
  })
  for (const file of new Set(files.trim().split('\n'))) {
    if (!existsSync(join(from, file))) continue
    mkdirSync(dirname(join(to, file)), { recursive: true })
    cpSync(join(from, file), join(to, file))
  }
  for (const folder of generated)
    if (existsSync(join(from, folder))) cpSync(join(from, folder), join(to, folder), { recursive: true })
  for (const folder of modules)
    if (existsSync(join(from, folder))) execFileSync('cp', ['-al', join(from, folder), join(to, folder)])
  writeFileSync(join(to, '.mutants'), '')
  return to
}
