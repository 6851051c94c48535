import { execFileSync, spawn, type ChildProcess } from 'node:child_process'
import { once } from 'node:events'
import { cpSync, mkdirSync, realpathSync } from 'node:fs'
import { dirname, join } from 'node:path'

/** The libraries that a program needs, and what loads them. */
function librariesOf(program: string): string[] {
  const listed = execFileSync('ldd', [program], { encoding: 'utf8' })
  return [...listed.matchAll(/(\/\S+) \(0x/g)].map(([, path]) => path!)
}

const inRoot = (root: string, path: string) => {
  mkdirSync(dirname(join(root, path)), { recursive: true })
  cpSync(realpathSync(path), join(root, path))
}

/**
 * A root of Linux with a shell and the libraries of the system alone: no Node, no package, no user's files.
 * @param programs whose libraries it holds
 */
export function makeBareRoot(root: string, programs: readonly string[]): void {
  const tools = ['/bin/sh', '/usr/bin/dirname', '/usr/bin/uname'].map((path) => realpathSync(path))
  for (const path of ['/bin/sh', '/usr/bin/dirname', '/usr/bin/uname']) inRoot(root, path)
  for (const path of new Set([...tools, ...programs].flatMap(librariesOf))) inRoot(root, path)
  // Every system has it: what the machine itself is called.
  inRoot(root, '/etc/hosts')
  for (const folder of ['proc', 'dev', 'tmp', 'etc']) mkdirSync(join(root, folder), { recursive: true })
}

interface Started {
  readonly process: ChildProcess
  /** What it has written so far. */
  readonly output: () => string
  readonly ended: Promise<number | null>
}

/** Its mounts end with the process. */
export function startInRoot(root: string, program: string, args: readonly string[], home: string): Started {
  const script = 'mount -t proc proc "$0/proc"; mount --bind /dev "$0/dev"; exec chroot "$0" /bin/sh "$@"'
  const before = ['--mount', '--propagation', 'private', 'sh', '-c', script, root]
  const child = spawn('unshare', [...before, program, ...args], {
    env: { HOME: home, PATH: '/usr/sbin:/usr/bin:/sbin:/bin', LANG: 'C.UTF-8' },
    stdio: ['ignore', 'pipe', 'pipe'],
  })
  let text = ''
  for (const stream of [child.stdout, child.stderr]) stream.on('data', (part) => (text += String(part)))
  const ended = once(child, 'exit').then(([code]) => code as number | null)
  return { process: child, output: () => text, ended }
}
