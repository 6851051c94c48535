declare module '@micropython/micropython-webassembly-pyscript/micropython.mjs' {
  export interface MicroPython {
    readonly FS: { mkdir(path: string): void; writeFile(path: string, text: string): void }
    registerJsModule(name: string, module: object): void
    runPython(text: string): void
  }
  export function loadMicroPython(options: {
    readonly heapsize: number
    readonly stdout?: (line: string) => void
  }): Promise<MicroPython>
}
