/** What the build knows about the files of Python for the browser (site/build/python.mjs). */
declare module "virtual:python-files" {
  export interface PythonFile {
    path: string;
    /** Size as it is transferred. */
    bytes: number;
  }
  /** Folder of the files; relative to the script that asks. */
  export const base: string;
  /** Folder of Pyodide's two scripts, below the base. */
  export const loader: string;
  /** Version of NumPy that the site has. */
  export const numpyVersion: string;
  export const files: Record<
    "interpreter" | "snapshot" | "sources" | "stdlib" | "numpy" | "yaml" | "judging",
    PythonFile
  >;
}
